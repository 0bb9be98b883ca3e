// Points of a friction curve, alone and beside sweeps.

#include <algorithm>
#include <cmath>
#include <iostream>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "joint/quantity.h"
#include "method/model/joint_log.h"
#include "statistics/random_stream.h"

namespace tribolog::model_points_test {
namespace {

using joint::FrictionPoints;
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

FrictionPoints points_of(const KnownJoint& joint, double noise_Nm, std::uint64_t seed) {
  statistics::RandomStream random(seed, 3);
  FrictionPoints p;
  p.name = "points.csv";
  for (const double speed : {1.0, 1.5, 2.0, 3.0, 5.0, 7.0, 10.0, 15.0, 20.0, 30.0, 45.0}) {
    for (const double signed_speed : {speed, -speed}) {
      p.speed_rad_s.push_back(signed_speed);
      p.torque_Nm.push_back(std::copysign(joint.friction_Nm(speed), signed_speed) +
                            noise_Nm * random.normal());
    }
  }
  return p;
}

TEST(ModelPoints, AloneAreFrictionAndNothingElse) {
  KnownJoint joint;
  for (const double dip_Nm : {0.0, 0.1}) {
    joint.dip_Nm = dip_Nm;
    const FrictionPoints points = points_of(joint, 0.002, 1);
    for (const bool has_gravity : {true, false}) {
      const ModelResult result = method::model::identify_joint({}, {points}, 50, has_gravity);
      EXPECT_EQ(result.cells, points.size());
      EXPECT_EQ(result.find(Quantity::gravity_torque), nullptr);
      EXPECT_EQ(result.find(Quantity::cog_angle), nullptr);
      EXPECT_EQ(result.find(Quantity::inertia), nullptr);
      EXPECT_TRUE(holds(found(result, Quantity::coulomb_torque), joint.coulomb_Nm));
      EXPECT_TRUE(holds(found(result, Quantity::viscous_coefficient), joint.viscous_Nms_rad));
      for (const double speed : {1.2, 4.0, 12.0, 40.0}) {
        const ModelQuantity& q = friction_at(result, speed);
        const double truth = joint.friction_Nm(q.speed_rad_s);
        EXPECT_TRUE(holds(q, truth)) << speed;
        EXPECT_LT(half_width(q), 0.1 * truth) << speed;
      }
    }
  }
}

TEST(ModelPoints, IntervalsHoldTheLaw) {
  KnownJoint joint;
  joint.dip_Nm = 0.1;
  constexpr int seeds = 40;
  int coulomb = 0;
  int viscous = 0;
  int friction = 0;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    const ModelResult result =
        method::model::identify_joint({}, {points_of(joint, 0.005, seed)}, 50, true);
    coulomb += holds(found(result, Quantity::coulomb_torque), joint.coulomb_Nm) ? 1 : 0;
    viscous += holds(found(result, Quantity::viscous_coefficient), joint.viscous_Nms_rad) ? 1 : 0;
    const ModelQuantity& q = friction_at(result, 10);
    friction += holds(q, joint.friction_Nm(q.speed_rad_s)) ? 1 : 0;
  }
  std::cout << "inside of " << seeds << ": Coulomb " << coulomb << ", viscous " << viscous
            << ", friction at 10 rad/s " << friction << "\n";
  EXPECT_GE(coulomb, 0.9 * seeds);
  EXPECT_GE(viscous, 0.9 * seeds);
  EXPECT_GE(friction, 0.9 * seeds);
}

TEST(ModelPoints, BesideSweepsSharpenFrictionAndLeaveGravity) {
  const KnownJoint joint;
  Session session;
  session.run_speeds_rad_s.clear();
  const JointLog log = record(joint, session, 1);
  const FrictionPoints points = points_of(joint, 0.005, 1);
  const ModelResult alone = log.identified(joint.gear_ratio);
  const ModelResult both =
      method::model::identify_joint(log.all(), {points}, joint.gear_ratio, true);
  EXPECT_EQ(both.cells, alone.cells + points.size());
  for (const auto& [quantity, truth] :
       {std::pair(Quantity::gravity_torque, joint.gravity_Nm),
        std::pair(Quantity::cog_angle, joint.q_peak_rad),
        std::pair(Quantity::coulomb_torque, joint.coulomb_Nm),
        std::pair(Quantity::viscous_coefficient, joint.viscous_Nms_rad),
        std::pair(Quantity::inertia, joint.inertia_kgm2)}) {
    EXPECT_TRUE(holds(found(both, quantity), truth)) << to_string(quantity);
  }
  EXPECT_LT(half_width(found(both, Quantity::viscous_coefficient)),
            half_width(found(alone, Quantity::viscous_coefficient)));
  const ModelQuantity& gravity = found(alone, Quantity::gravity_torque);
  EXPECT_NEAR(found(both, Quantity::gravity_torque).estimate, gravity.estimate,
              0.5 * half_width(gravity));
  const ModelQuantity& fast = friction_at(both, 40);
  EXPECT_TRUE(holds(fast, joint.friction_Nm(fast.speed_rad_s)));
}

TEST(ModelPoints, FewOrAtRestSayNothing) {
  FrictionPoints points = points_of({}, 0, 1);
  points.speed_rad_s.resize(8);
  points.torque_Nm.resize(8);
  EXPECT_TRUE(method::model::identify_joint({}, {points}, 50, true).empty());
  points = points_of({}, 0, 1);
  std::fill(points.speed_rad_s.begin(), points.speed_rad_s.end(), 0.0);
  EXPECT_TRUE(method::model::identify_joint({}, {points}, 50, true).empty());
}

}  // namespace
}  // namespace tribolog::model_points_test
