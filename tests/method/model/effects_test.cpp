// Each effect of the catalogue at three times its typical size: the numbers stay inside their
// intervals, and the data show the effect, or another of the same columns.

#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "joint/quantity.h"
#include "method/model/joint_log.h"

namespace tribolog::model_effects_test {
namespace {

using joint::Quantity;
using method::model::ModelQuantity;
using method::model::ModelResult;
using test::found;
using test::friction_at;
using test::holds;
using test::KnownJoint;
using test::SmallEffects;

struct Injected {
  std::string name;
  std::vector<std::string> seen_as;  ///< One of these.
  std::function<void(SmallEffects&)> inject;
  test::Session session{};
};

/// Over most of a turn: over less of it a spring is a part of gravity.
test::Session wide() {
  test::Session session;
  session.low_rad = -2.9;
  session.high_rad = 2.7;
  return session;
}

void PrintTo(const Injected& one, std::ostream* out) { *out << one.name; }

class InjectedEffect : public testing::TestWithParam<Injected> {};

TEST_P(InjectedEffect, IsShownAndLeavesTheNumbersInsideTheirIntervals) {
  constexpr std::uint64_t seeds = 5;
  int shown = 0;
  int inside = 0;
  int asked = 0;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    KnownJoint joint;
    joint.noise_Nm = 0.003;
    const ModelResult without =
        record(joint, GetParam().session, seed).identified(joint.gear_ratio);
    GetParam().inject(joint.effects);
    const ModelResult with = record(joint, GetParam().session, seed).identified(joint.gear_ratio);
    const auto ask = [&](const ModelQuantity& q, double truth, const std::string& name) {
      ++asked;
      if (holds(q, truth)) {
        ++inside;
      } else {
        std::cout << GetParam().name << ", seed " << seed << ": " << name << " " << q.estimate
                  << " (" << q.low << " to " << q.high << "), truth " << truth << "\n";
      }
    };
    ask(found(with, Quantity::gravity_torque), joint.gravity_Nm, "gravity");
    ask(found(with, Quantity::cog_angle), joint.q_peak_rad, "angle");
    ask(found(with, Quantity::coulomb_torque), joint.coulomb_Nm, "Coulomb");
    ask(found(with, Quantity::viscous_coefficient), joint.viscous_Nms_rad, "viscous");
    ask(found(with, Quantity::inertia), joint.inertia_kgm2, "inertia");
    for (const double speed : {3.0, 10.0, 30.0}) {
      const ModelQuantity& q = friction_at(with, speed);
      ask(q, joint.friction_Nm(q.speed_rad_s), "friction at " + std::to_string(speed));
    }
    const bool is_shown = std::any_of(GetParam().seen_as.begin(), GetParam().seen_as.end(),
                                      [&](const std::string& key) {
                                        return found(with, key).chi2 > found(without, key).chi2 + 5;
                                      });
    shown += is_shown ? 1 : 0;
  }
  std::cout << GetParam().name << ": inside " << inside << " of " << asked << ", shown " << shown
            << " of " << seeds << "\n";
  EXPECT_GE(inside, 0.95 * asked);
  EXPECT_EQ(shown, seeds);
}

INSTANTIATE_TEST_SUITE_P(
    ModelEffects, InjectedEffect,
    testing::Values(
        Injected{"offset", {"offset"}, [](SmallEffects& e) { e.offset = 0.04; }},
        Injected{"offset_drift", {"offset_drift"}, [](SmallEffects& e) { e.offset_drift = 0.006; }},
        Injected{"lag", {"lag", "position"}, [](SmallEffects& e) { e.lag_s = 0.003; }},
        Injected{"load", {"load"}, [](SmallEffects& e) { e.load = 0.03; }},
        Injected{"asymmetry", {"asymmetry"}, [](SmallEffects& e) { e.asymmetry_of_speed = 0.06; }},
        Injected{"position",
                 {"position", "load"},
                 [](SmallEffects& e) { e.place = {0.06, -0.03, 0.02, 0.015, -0.012}; }},
        Injected{"drift", {"drift", "law_misfit"}, [](SmallEffects& e) { e.warm_up[1] = 0.1; }},
        Injected{"spring",
                 {"spring", "harmonics", "smooth_over_angle", "angle_scale"},
                 [](SmallEffects& e) { e.spring = 0.003; },
                 wide()},
        Injected{"torque_nonlinear", {"torque_nonlinear"}, [](SmallEffects& e) { e.cube = 0.01; }},
        Injected{"gain_of_runs",
                 {"gain_of_runs", "gain_drift", "gain_of_speed"},
                 [](SmallEffects& e) { e.gain_of_runs = 0.006; }},
        Injected{"gain_drift",
                 {"gain_drift", "gain_of_runs"},
                 [](SmallEffects& e) { e.gain_drift = 0.006; }},
        Injected{"harmonics",
                 {"harmonics", "smooth_over_angle"},
                 [](SmallEffects& e) { e.harmonics = {0, 0.002, 0.0015, 0}; }}),
    [](const testing::TestParamInfo<Injected>& one) { return one.param.name; });

}  // namespace
}  // namespace tribolog::model_effects_test
