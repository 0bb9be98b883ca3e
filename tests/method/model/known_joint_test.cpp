// Joints whose truth is known: every number lies inside its interval, and the interval is not wide
// for nothing.

#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "joint/quantity.h"
#include "method/model/joint_log.h"
#include "statistics/random_stream.h"
#include "support/breadth.h"

namespace tribolog::known_joint_test {
namespace {

using joint::Quantity;
using method::model::ModelQuantity;
using method::model::ModelResult;
using test::found;
using test::friction_at;
using test::half_width;
using test::holds;
using test::JointLog;
using test::KnownJoint;
using test::Session;
using test::SmallEffects;

/// Speeds of the motor between those of the session's runs.
constexpr double speeds_rad_s[] = {3.5, 8, 15, 25, 40};

struct Outcome {
  double truth{};
  ModelQuantity found;
};

std::map<std::string, Outcome> outcomes(const KnownJoint& joint, const ModelResult& result) {
  std::map<std::string, Outcome> all;
  all["gravity"] = {joint.gravity_Nm, found(result, Quantity::gravity_torque)};
  all["angle"] = {joint.q_peak_rad, found(result, Quantity::cog_angle)};
  all["Coulomb"] = {joint.coulomb_Nm, found(result, Quantity::coulomb_torque)};
  all["viscous"] = {joint.viscous_Nms_rad, found(result, Quantity::viscous_coefficient)};
  all["inertia"] = {joint.inertia_kgm2, found(result, Quantity::inertia)};
  for (const double speed : speeds_rad_s) {
    const ModelQuantity& q = friction_at(result, speed);
    all["friction at " + std::to_string(std::lround(speed)) + " rad/s"] = {
        joint.friction_Nm(q.speed_rad_s), q};
  }
  return all;
}

/// Of the truth; of an angle in radian.
double relative_width(const std::string& name, const Outcome& one) {
  return half_width(one.found) / (name == "angle" ? 1 : std::abs(one.truth));
}

struct Coverage {
  int inside{};
  int seeds{};
  std::vector<double> widths;
  std::vector<double> errors;

  [[nodiscard]] double share() const { return static_cast<double>(inside) / seeds; }
  [[nodiscard]] double median_width() const {
    std::vector<double> sorted = widths;
    std::sort(sorted.begin(), sorted.end());
    return sorted[sorted.size() / 2];
  }
};

std::map<std::string, Coverage> coverage(const KnownJoint& joint, const Session& session,
                                         bool with_effects, std::size_t seeds) {
  std::map<std::string, Coverage> all;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    KnownJoint one = joint;
    if (with_effects) {
      const double friction = joint.friction_Nm(15);
      one.effects = SmallEffects::draw(seed, friction / (joint.gravity_Nm + friction));
    }
    const JointLog log = record(one, session, seed);
    for (const auto& [name, outcome] : outcomes(joint, log.identified(joint.gear_ratio))) {
      Coverage& c = all[name];
      const bool inside = holds(outcome.found, outcome.truth);
      c.inside += inside ? 1 : 0;
      ++c.seeds;
      c.widths.push_back(relative_width(name, outcome));
      c.errors.push_back(std::abs(outcome.found.estimate - outcome.truth) /
                         (name == "angle" ? 1 : std::abs(outcome.truth)));
    }
  }
  for (const auto& [name, c] : all) {
    std::vector<double> errors = c.errors;
    std::sort(errors.begin(), errors.end());
    std::cout << "  " << name << ": " << c.inside << " of " << c.seeds << " inside, half width "
              << c.median_width() << ", median error " << errors[errors.size() / 2] << ", largest "
              << errors.back() << "\n";
  }
  return all;
}

constexpr std::size_t every_change = 40;
constexpr std::size_t every_night = 400;

/// Largest median half width of each quantity: about a quarter above what was measured.
struct Widths {
  double gravity, angle_rad, coulomb, viscous, inertia, friction;

  [[nodiscard]] double of(const std::string& name) const {
    if (name == "gravity") return gravity;
    if (name == "angle") return angle_rad;
    if (name == "Coulomb") return coulomb;
    if (name == "viscous") return viscous;
    if (name == "inertia") return inertia;
    return friction;
  }
};

void expect_coverage(const KnownJoint& joint, bool with_effects, const Widths& widest) {
  const std::size_t seeds = test::seeds_of(every_change, every_night);
  for (const auto& [name, c] : coverage(joint, {}, with_effects, seeds)) {
    EXPECT_GE(c.share(), 0.88) << name;
    EXPECT_LE(c.median_width(), widest.of(name)) << name;
  }
}

KnownJoint with_dip() {
  KnownJoint joint;
  joint.dip_Nm = 0.12;
  return joint;
}

TEST(KnownJoint, OfALineIsFound) {
  expect_coverage({}, false, {0.010, 0.0072, 0.054, 0.062, 0.012, 0.054});
}

TEST(KnownJoint, OfALineWithSmallEffectsIsFound) {
  expect_coverage({}, true, {0.012, 0.0080, 0.054, 0.066, 0.016, 0.054});
}

TEST(KnownJoint, WithADipIsFound) {
  expect_coverage(with_dip(), false, {0.010, 0.0072, 0.072, 0.14, 0.012, 0.054});
}

TEST(KnownJoint, WithADipAndSmallEffectsIsFound) {
  expect_coverage(with_dip(), true, {0.012, 0.0080, 0.074, 0.15, 0.016, 0.054});
}

TEST(KnownJoint, NoisyAnglesAndOtherRatesAreNoOtherJoint) {
  const KnownJoint joint = with_dip();
  for (const double dt_s : {0.001, 0.008, 0.02}) {
    Session session;
    session.dt_s = dt_s;
    int inside = 0;
    int asked = 0;
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
      JointLog log = record(joint, session, seed);
      statistics::RandomStream random(seed, 99);
      for (joint::Recording& r : log.recordings) {
        for (double& q : r.q_rad) q += 2e-5 * random.normal();
      }
      for (const auto& [name, outcome] : outcomes(joint, log.identified(joint.gear_ratio))) {
        ++asked;
        inside += holds(outcome.found, outcome.truth) ? 1 : 0;
        // Of dip or power of the speed, either may be the law.
        EXPECT_LT(relative_width(name, outcome), name == "viscous" ? 0.7 : 0.3)
            << name << ", dt " << dt_s;
      }
    }
    std::cout << "  every " << dt_s << " s: " << inside << " of " << asked << " inside\n";
    EXPECT_GE(inside, 0.93 * asked) << dt_s;
  }
}

// Of a square root of the speed, which no law has: friction at the speeds is found where its limits
// are not.
TEST(KnownJoint, FrictionAtSpeedsNeedsNoLaw) {
  KnownJoint joint = with_dip();
  joint.viscous_Nms_rad = 0;
  joint.bend_Nm = 0.25;
  int inside = 0;
  int asked = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const ModelResult result = record(joint, {}, seed).identified(joint.gear_ratio);
    for (const double speed : speeds_rad_s) {
      const ModelQuantity& q = friction_at(result, speed);
      ++asked;
      inside += holds(q, joint.friction_Nm(q.speed_rad_s)) ? 1 : 0;
      EXPECT_LT(half_width(q), 0.08 * q.estimate) << speed;
    }
  }
  std::cout << "  " << inside << " of " << asked << " inside\n";
  EXPECT_GE(inside, 0.93 * asked);
}

}  // namespace
}  // namespace tribolog::known_joint_test
