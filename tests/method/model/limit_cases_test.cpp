// Joints and logs that leave something out: what the data do not show is wide or absent, never
// invented.

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "joint/quantity.h"
#include "method/model/joint_log.h"
#include "statistics/random_stream.h"

namespace tribolog::model_limit_cases_test {
namespace {

using joint::Quantity;
using joint::Recording;
using method::model::ModelQuantity;
using method::model::ModelResult;
using test::found;
using test::friction_at;
using test::half_width;
using test::holds;
using test::JointLog;
using test::KnownJoint;
using test::Session;

double relative_width(const ModelQuantity& q) { return half_width(q) / std::abs(q.estimate); }

TEST(ModelLimitCases, TurningJointWithoutGravityHasFrictionAndInertia) {
  KnownJoint joint;
  joint.gravity_Nm = 0;
  Session session;
  session.low_rad = -8;
  session.high_rad = 8;
  session.sweep_speed_rad_s = 0.5;
  const ModelResult result = record(joint, session, 1).identified(joint.gear_ratio, false);
  EXPECT_EQ(result.find(Quantity::gravity_torque), nullptr);
  EXPECT_EQ(result.find(Quantity::cog_angle), nullptr);
  EXPECT_TRUE(holds(found(result, Quantity::coulomb_torque), joint.coulomb_Nm));
  EXPECT_TRUE(holds(found(result, Quantity::viscous_coefficient), joint.viscous_Nms_rad));
  EXPECT_TRUE(holds(found(result, Quantity::inertia), joint.inertia_kgm2));
  const ModelQuantity& friction = friction_at(result, 20);
  EXPECT_TRUE(holds(friction, joint.friction_Nm(friction.speed_rad_s)));
  EXPECT_LT(relative_width(friction), 0.08);
  EXPECT_NO_THROW(found(result, "torque_over_turn"));
}

TEST(ModelLimitCases, JointOfVerticalAxisMayHaveSomeGravityLeft) {
  KnownJoint joint;
  joint.gravity_Nm = 0.01;  // 2 % of the torque
  const ModelResult result = record(joint, {}, 1).identified(joint.gear_ratio, false);
  EXPECT_EQ(result.find(Quantity::gravity_torque), nullptr);
  EXPECT_NO_THROW(found(result, "gravity_left"));
  EXPECT_TRUE(holds(found(result, Quantity::coulomb_torque), joint.coulomb_Nm));
  EXPECT_TRUE(holds(found(result, Quantity::viscous_coefficient), joint.viscous_Nms_rad));
}

TEST(ModelLimitCases, OneDirectionInventsNoCoulombTorque) {
  for (const bool up : {true, false}) {
    KnownJoint joint;
    joint.effects.offset = 0.06;
    Session session;
    session.up = up;
    session.down = !up;
    const ModelResult result = record(joint, session, 1).identified(joint.gear_ratio);
    const ModelQuantity& coulomb = found(result, Quantity::coulomb_torque);
    EXPECT_TRUE(holds(coulomb, joint.coulomb_Nm));
    EXPECT_GT(half_width(coulomb), 0.3 * joint.coulomb_Nm);
    EXPECT_GT(half_width(friction_at(result, 20)), 0.3 * joint.coulomb_Nm);
    EXPECT_EQ(coulomb.shares.at(0).effect, "offset");
  }
}

TEST(ModelLimitCases, OneSpeedShowsNoViscousTorque) {
  KnownJoint joint;
  joint.inertia_kgm2 = 1e-3;
  Session session;
  session.sweeps = 0;
  session.run_way_rad = 2.2;
  session.run_speeds_rad_s = {0.3, 0.3, 0.3};
  session.acceleration_rad_s2 = 20;
  const ModelResult result = record(joint, session, 1).identified(joint.gear_ratio);
  const ModelQuantity& friction = friction_at(result, 15);
  EXPECT_TRUE(holds(friction, joint.friction_Nm(friction.speed_rad_s)));
  EXPECT_LT(relative_width(friction), 0.1);
  const ModelQuantity* viscous = result.find(Quantity::viscous_coefficient);
  if (viscous != nullptr) {
    EXPECT_GT(half_width(*viscous), 0.5 * joint.viscous_Nms_rad);
    EXPECT_TRUE(holds(*viscous, joint.viscous_Nms_rad));
  }
}

TEST(ModelLimitCases, SweepsAloneAndRunsAloneAgree) {
  const KnownJoint joint;
  Session sweeps;
  sweeps.run_speeds_rad_s.clear();
  sweeps.sweeps = 3;
  Session runs;
  runs.sweeps = 0;
  for (const Session& session : {sweeps, runs}) {
    const ModelResult result = record(joint, session, 1).identified(joint.gear_ratio);
    EXPECT_TRUE(holds(found(result, Quantity::gravity_torque), joint.gravity_Nm));
    EXPECT_TRUE(holds(found(result, Quantity::cog_angle), joint.q_peak_rad));
    EXPECT_TRUE(holds(found(result, Quantity::coulomb_torque), joint.coulomb_Nm));
  }
}

TEST(ModelLimitCases, DirectDriveIsAGearOfOne) {
  KnownJoint joint;
  joint.gear_ratio = 1;
  joint.gravity_Nm = 50;
  joint.coulomb_Nm = 12;
  joint.viscous_Nms_rad = 10;
  joint.inertia_kgm2 = 5;
  joint.noise_Nm = 0.5;
  const ModelResult result = record(joint, {}, 1).identified(1);
  EXPECT_TRUE(holds(found(result, Quantity::gravity_torque), joint.gravity_Nm));
  EXPECT_TRUE(holds(found(result, Quantity::coulomb_torque), joint.coulomb_Nm));
  EXPECT_TRUE(holds(found(result, Quantity::viscous_coefficient), joint.viscous_Nms_rad));
  EXPECT_TRUE(holds(found(result, Quantity::inertia), joint.inertia_kgm2));
}

TEST(ModelLimitCases, FrictionIsStatedAtMeasuredSpeedsAlone) {
  const KnownJoint joint;
  const ModelResult result = record(joint, {}, 1).identified(joint.gear_ratio);
  double last = 0;
  for (const ModelQuantity& q : result.quantities) {
    if (q.quantity) continue;
    EXPECT_GT(q.speed_rad_s, last);
    EXPECT_GT(q.speed_rad_s, 0.5);
    EXPECT_LT(q.speed_rad_s, 46);
    if (last > 0) {
      EXPECT_LT(q.speed_rad_s / last, 1.04) << "any speed is within 2 % of one";
    }
    last = q.speed_rad_s;
  }
  EXPECT_GT(last, 44);
}

TEST(ModelLimitCases, NothingFollowsFromNothing) {
  EXPECT_TRUE(JointLog{}.identified(50).empty());
  JointLog log;
  log.recordings.resize(2);
  EXPECT_TRUE(log.identified(50).empty());
  EXPECT_TRUE(log.identified(50, false).empty());
}

TEST(ModelLimitCases, DeadTorqueSaysNothing) {
  for (const double level : {0.0, 1.5}) {
    JointLog log = test::record({}, {}, 1);
    for (Recording& r : log.recordings) r.torque_Nm.assign(r.size(), level);
    EXPECT_TRUE(log.identified(50).empty()) << level;
  }
  JointLog log = test::record({}, {}, 1);
  for (Recording& r : log.recordings) r.torque_Nm.clear();
  EXPECT_TRUE(log.identified(50).empty()) << "not recorded";
}

TEST(ModelLimitCases, RestSaysNothing) {
  JointLog log = test::record({}, {}, 1);
  statistics::RandomStream random(1, 0);
  for (Recording& r : log.recordings) {
    for (double& q : r.q_rad) q = 0.3 + 1e-6 * random.normal();
  }
  EXPECT_TRUE(log.identified(50).empty());
}

TEST(ModelLimitCases, FewCellsSayNothing) {
  Session session;
  session.sweeps = 0;
  session.run_speeds_rad_s = {0.1};
  session.run_way_rad = 0.06;
  session.down = false;
  EXPECT_TRUE(test::record({}, session, 1).identified(50).empty());
}

// Their time and place are: by these friction there is compared with that of the runs.
TEST(ModelLimitCases, TheTorqueOfOtherRolesIsNotRead) {
  const JointLog log = test::record({}, {}, 1);
  const ModelResult alone = log.identified(50);
  std::vector<ModelResult> beside;
  for (const double factor : {1.0, 3.0}) {
    JointLog more = log;
    Recording other = log.recordings[0];
    for (double& torque : other.torque_Nm) torque *= factor;
    for (const joint::Role role : {joint::Role::oscillation, joint::Role::break_away}) {
      other.role = role;
      more.recordings.push_back(other);
    }
    beside.push_back(more.identified(50));
    EXPECT_EQ(beside.back().cells, alone.cells);
  }
  for (const Quantity quantity : {Quantity::coulomb_torque, Quantity::gravity_torque}) {
    EXPECT_EQ(found(beside[1], quantity).estimate, found(beside[0], quantity).estimate);
    const statistics::Estimate without = found(alone, quantity).as_estimate();
    EXPECT_NEAR(found(beside[0], quantity).estimate, without.value, 0.1 * without.half_width());
  }
}

}  // namespace
}  // namespace tribolog::model_limit_cases_test
