#include "paper/wrong_joints.h"

#include <memory>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "base/requirements.h"
#include "friction/static_laws.h"
#include "joint/degrees.h"
#include "paper/checks/check.h"
#include "paper/checks/paper_items.h"

namespace tribolog::paper::paper_checks_test {

namespace {

using checks::Check;
using checks::Kind;
using checks::PaperItem;
using checks::PapersJoint;

/// The paper's joint with changes, each from the joint as it is.
class WrongJoints {
 public:
  explicit WrongJoints(const PapersJoint& joint) : joint_(joint) {}

  template <class Change>
  void add(std::string name, const Change& change) {
    WrongJoint one{std::move(name), joint_.scenario, joint_.laws};
    change(one);
    all.push_back(std::move(one));
  }
  /// Of the bristles.
  template <class Change>
  void add_bristles(std::string name, const Change& change) {
    add(std::move(name), [&](WrongJoint& one) {
      friction::LuGreFriction::Parameters p = checks::bristles_of(one.scenario).parameters();
      change(p);
      one.scenario.presliding = std::make_shared<friction::LuGreFriction>(p);
    });
  }
  /// Of what slides.
  template <class Change>
  void add_sliding(std::string name, const Change& change) {
    add(std::move(name), [&](WrongJoint& one) {
      friction::WaiboerFriction::Parameters p = checks::sliding_of(one.scenario).parameters();
      change(p);
      one.scenario.sliding = std::make_shared<friction::WaiboerFriction>(p);
    });
  }
  std::vector<WrongJoint> all;

 private:
  const PapersJoint& joint_;
};

joint::GravityLoad load_with(const joint::GravityLoad& load, double mass_factor,
                             double distance_factor, double q_shift_rad) {
  return {load.mass_kg() * mass_factor, load.distance_m() * distance_factor,
          load.q_peak_rad() + q_shift_rad, load.gravity_m_s2()};
}

std::string times(const char* symbol, const char* factor) {
  return fmt::format("{} × {}", symbol, factor);
}

void add_of_bristles(WrongJoints& out) {
  using P = friction::LuGreFriction::Parameters;
  out.add_bristles(times("σ₀", "2"), [](P& p) { p.bristle_stiffness_Nm_rad *= 2; });
  out.add_bristles(times("σ₀", "0.3"), [](P& p) { p.bristle_stiffness_Nm_rad *= 0.3; });
  out.add_bristles(times("σ₁", "3"), [](P& p) { p.bristle_damping_Nms_rad *= 3; });
  out.add_bristles(times("σ₂", "100"), [](P& p) { p.viscous_Nms_rad *= 100; });
  out.add_bristles(times("T_s", "1.3"), [](P& p) { p.static_Nm *= 1.3; });
  out.add_bristles(times("T_c", "0.2"), [](P& p) { p.coulomb_Nm *= 0.2; });
  out.add_bristles(times("ω_s", "0.01"), [](P& p) { p.stribeck_speed_rad_s *= 0.01; });
}

void add_of_arm(WrongJoints& out) {
  out.add("n = 80", [](WrongJoint& one) { one.scenario.gear_ratio = 80; });
  out.add(times("m", "1.2"),
          [](WrongJoint& one) { one.scenario.load = load_with(one.scenario.load, 1.2, 1, 0); });
  out.add(times("r", "0.9"),
          [](WrongJoint& one) { one.scenario.load = load_with(one.scenario.load, 1, 0.9, 0); });
  out.add("q_peak + 2°", [](WrongJoint& one) {
    one.scenario.load = load_with(one.scenario.load, 1, 1, 2 * joint::rad_per_degree);
  });
  out.add("r_REPL = 0.6 m", [](WrongJoint& one) { one.scenario.surrogate_distance_m = 0.6; });
  out.add(times("J", "1000"), [](WrongJoint& one) { one.scenario.motor_inertia_kgm2 *= 1000; });
  out.add(times("I", "100"), [](WrongJoint& one) { one.scenario.arm_inertia_kgm2 *= 100; });
  out.add("friction that grows by 5 % of the load",
          [](WrongJoint& one) { one.scenario.effects.load_friction = 0.05; });
}

void add_of_motion(WrongJoints& out) {
  out.add("oscillation at 3 Hz",
          [](WrongJoint& one) { present(one.scenario.oscillation).frequency_Hz = 3; });
  out.add("amplitude × 0.3",
          [](WrongJoint& one) { present(one.scenario.oscillation).amplitude_rad *= 0.3; });
  out.add("amplitude × 3",
          [](WrongJoint& one) { present(one.scenario.oscillation).amplitude_rad *= 3; });
  out.add("oscillation 5° off", [](WrongJoint& one) {
    present(one.scenario.oscillation).centre_rad += 5 * joint::rad_per_degree;
  });
  out.add("angle counted the other way round",
          [](WrongJoint& one) { one.scenario.noise.effects.mirrored_angle = true; });
}

void add_of_sliding(WrongJoints& out) {
  using P = friction::WaiboerFriction::Parameters;
  out.add_sliding(times("T_a", "1.5"), [](P& p) { p.asperity_torque_Nm *= 1.5; });
  out.add_sliding(times("c", "0.001"), [](P& p) { p.smoothing_s_rad *= 1e-3; });
}

void add_of_laws(WrongJoints& out) {
  out.add("figure 2 with a decay 1000 times as fast", [](WrongJoint& one) {
    friction::ThresholdSpeedFriction::Parameters p = one.laws.continuous.parameters();
    p.stribeck_decay_s_rad *= 1000;
    one.laws.continuous = friction::ThresholdSpeedFriction(p);
  });
  out.add("figure 5 with σ₀ × 2", [](WrongJoint& one) { one.laws.contact.stiffness_Nm_rad *= 2; });
  out.add("figure 5 with T_s = T_c = 0.9 N", [](WrongJoint& one) {
    one.laws.contact.static_Nm = 0.9;
    one.laws.contact.coulomb_Nm = 0.9;
  });
}

}  // namespace

std::vector<WrongJoint> wrong_joints(const PapersJoint& joint) {
  WrongJoints out(joint);
  add_of_bristles(out);
  add_of_arm(out);
  add_of_motion(out);
  add_of_sliding(out);
  add_of_laws(out);
  return std::move(out.all);
}

namespace {

/// Of all items, in their order.
template <class Use>
void for_each_of_print(const std::vector<PaperItem>& items, Use use) {
  for (const PaperItem& item : items) {
    for (const Check& check : item.checks) {
      if (check.kind == Kind::print) use(item, check);
    }
  }
}

}  // namespace

WrongJointsResult try_wrong_joints(const PapersJoint& joint, const std::vector<WrongJoint>& wrong) {
  WrongJointsResult out;
  for_each_of_print(checks::items_of_print(joint), [&](const PaperItem& item, const Check& check) {
    out.checks.push_back({checks::item_name(item), check.what, {}});
  });
  for (const WrongJoint& one : wrong) {
    const PapersJoint other(one.scenario, joint.robot, one.laws);
    std::size_t k = 0;
    bool is_noticed = false;
    for_each_of_print(checks::items_of_print(other), [&](const PaperItem&, const Check& check) {
      if (k == out.checks.size()) throw std::logic_error("a wrong joint has more checks of print");
      if (!check.holds()) out.checks[k].joints.push_back(one.name);
      is_noticed = is_noticed || !check.holds();
      ++k;
    });
    if (k != out.checks.size()) throw std::logic_error("a wrong joint has fewer checks of print");
    if (!is_noticed) out.unnoticed.push_back(one.name);
  }
  return out;
}

}  // namespace tribolog::paper::paper_checks_test
