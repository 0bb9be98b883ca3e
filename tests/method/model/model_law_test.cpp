// The law of friction that the model states: its dip, and what is not known of it.

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "method/model/joint_log.h"
#include "support/breadth.h"

namespace tribolog::test::model_law_test {
namespace {

constexpr double per_joint_speed = 50;  // the gear

Session from_slow_to_fast() {
  Session session;
  session.run_speeds_rad_s.clear();
  for (int k = 0; k < 12; ++k) session.run_speeds_rad_s.push_back(0.01 * std::pow(1.5, k));
  return session;
}

KnownJoint with_dip(double dip_Nm, double speed_rad_s) {
  KnownJoint joint;
  joint.dip_Nm = dip_Nm;
  joint.dip_speed_rad_s = speed_rad_s;
  joint.noise_Nm = 0.004;
  return joint;
}

TEST(ModelLaw, IsTheFrictionOfTheJoint) {
  const KnownJoint joint = with_dip(0.1, 3);
  const auto found = record(joint, from_slow_to_fast(), 1).identified(joint.gear_ratio);
  const method::model::ModelLaw& law = found.law;
  ASSERT_FALSE(law.empty());
  EXPECT_NEAR(law.fastest_rad_s, per_joint_speed * 0.01 * std::pow(1.5, 11), 0.5);
  for (const double speed : {0.6, 3.0, 12.0, 40.0}) {
    EXPECT_NEAR(law.friction_Nm(speed) / joint.friction_Nm(speed), 1, 0.03) << speed;
  }
}

TEST(ModelLaw, TheStribeckVelocityLiesInItsInterval) {
  int inside = 0;
  int narrow = 0;
  const auto seeds = static_cast<int>(seeds_of(10, 40));
  for (int seed = 1; seed <= seeds; ++seed) {
    const KnownJoint joint = with_dip(0.1, 3);
    const auto found = record(joint, from_slow_to_fast(), static_cast<std::uint64_t>(seed))
                           .identified(joint.gear_ratio);
    ASSERT_TRUE(found.law.has_dip());
    const statistics::Estimate& speed = *found.law.stribeck_speed_rad_s;
    inside += speed.low <= joint.dip_speed_rad_s && joint.dip_speed_rad_s <= speed.high ? 1 : 0;
    narrow += speed.half_width() < 0.3 * joint.dip_speed_rad_s ? 1 : 0;
    EXPECT_LE(found.law.lowest_power, 1) << "the joint's own";
    EXPECT_GE(found.law.highest_power, 1);
  }
  EXPECT_GE(inside, seeds - std::max(1, seeds / 10));
  EXPECT_GE(narrow, 9 * seeds / 10);
}

TEST(ModelLaw, AStraightLineHasNoDip) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const KnownJoint joint = with_dip(0, 3);
    const auto found = record(joint, from_slow_to_fast(), seed).identified(joint.gear_ratio);
    EXPECT_FALSE(found.law.has_dip()) << seed;
    EXPECT_FALSE(found.rest_Nm);
    EXPECT_LT(found.law.bend_probability, 0.95) << seed;
  }
}

TEST(ModelLaw, FrictionAtRestIsStatedWhereTheRunsReachIntoTheDip) {
  const KnownJoint joint = with_dip(0.1, 3);
  const auto found = record(joint, from_slow_to_fast(), 4).identified(joint.gear_ratio);
  ASSERT_TRUE(found.rest_Nm);
  EXPECT_LE(found.rest_Nm->low, joint.coulomb_Nm + joint.dip_Nm);
  EXPECT_GE(found.rest_Nm->high, joint.coulomb_Nm + joint.dip_Nm);
  Session fast = from_slow_to_fast();
  fast.run_speeds_rad_s.erase(fast.run_speeds_rad_s.begin(), fast.run_speeds_rad_s.begin() + 6);
  fast.sweeps = 0;
  EXPECT_FALSE(record(joint, fast, 4).identified(joint.gear_ratio).rest_Nm);
}

}  // namespace
}  // namespace tribolog::test::model_law_test
