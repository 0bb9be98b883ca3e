#include "robot/joint_under_test.h"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include <gtest/gtest.h>

#include "ingest/robot_file.h"

namespace tribolog {
namespace {

constexpr double pi = std::numbers::pi;

JointUnderTest example() {
  return read_robot(TRIBOLOG_SOURCE_DIR "/examples/paper/am100ib.toml").under_test;
}

JointUnderTest::Setting changed() { return example().setting(); }

TEST(JointUnderTest, HasItsMassCentreLevelAtThePeakOfGravity) {
  const JointUnderTest test = example();
  const double q_peak = test.load().q_peak_rad();
  const Eigen::Vector3d arm = test.mass_centre_m(q_peak) - test.place_m();
  EXPECT_NEAR(arm.z(), 0.0, 1e-12);
  EXPECT_NEAR(arm.norm(), 0.4, 1e-12);
  EXPECT_NEAR(arm.x(), 0.4, 1e-12) << "in front of the joint";
  const double largest = test.holding_torque_Nm(q_peak);
  for (double q = test.setting().lowest_rad; q < test.setting().highest_rad; q += 0.01) {
    EXPECT_LE(test.holding_torque_Nm(q), largest);
  }
}

// The lever and the weight in space against m g r cos(q - q_peak).
TEST(JointUnderTest, AsksTheTorqueOfItsGravityLoad) {
  const JointUnderTest test = example();
  for (double q = test.setting().lowest_rad; q < test.setting().highest_rad; q += 0.05) {
    EXPECT_NEAR(test.holding_torque_Nm(q), test.load().torque_Nm(q), 1e-9);
  }
}

TEST(JointUnderTest, KeepsTheMassCentreInItsLink) {
  const JointUnderTest test = example();
  const std::size_t joint = test.setting().joint;
  const Eigen::Vector3d in_link = test.pose(0).frames[joint].inverse() * test.mass_centre_m(0);
  EXPECT_NEAR(std::atan2(in_link.z(), in_link.x()), -test.load().q_peak_rad(), 1e-12);
  for (const double q : {-1.3, -0.4, 0.2, 1.0}) {
    const Eigen::Vector3d again = test.pose(q).frames[joint].inverse() * test.mass_centre_m(q);
    EXPECT_LT((again - in_link).norm(), 1e-12);
  }
}

TEST(JointUnderTest, GivesTheSurrogateMassTheSameTorque) {
  const JointUnderTest test = example();
  EXPECT_NEAR(test.surrogate_mass_kg(), 79.1679, 5e-5);
  for (const double q : {-1.3, -0.4, 0.2, 1.0}) {
    const double lever = test.surrogate_centre_m(q).x() - test.place_m().x();
    EXPECT_NEAR(test.surrogate_mass_kg() * test.load().gravity_m_s2() * lever,
                test.holding_torque_Nm(q), 1e-9);
  }
  // Twice as far, half the mass.
  JointUnderTest::Setting far = changed();
  far.surrogate_distance_m *= 2;
  EXPECT_NEAR(JointUnderTest(test.arm(), far).surrogate_mass_kg(), test.surrogate_mass_kg() / 2,
              1e-12);
}

TEST(JointUnderTest, RefusesATiltedAxisAndAnEmptyRange) {
  const SerialArm arm = example().arm();
  JointUnderTest::Setting bad = changed();
  bad.joint = 0;
  EXPECT_THROW(JointUnderTest(arm, bad), std::invalid_argument);
  bad = changed();
  bad.joint = 6;
  EXPECT_THROW(JointUnderTest(arm, bad), std::invalid_argument);
  bad = changed();
  bad.lowest_rad = bad.highest_rad;
  EXPECT_THROW(JointUnderTest(arm, bad), std::invalid_argument);
  bad = changed();
  bad.highest_rad = 2 * pi;
  EXPECT_THROW(JointUnderTest(arm, bad), std::invalid_argument);
  bad = changed();
  bad.surrogate_distance_m = 0;
  EXPECT_THROW(JointUnderTest(arm, bad), std::invalid_argument);
  bad = changed();
  bad.held_rad.pop_back();
  EXPECT_THROW(JointUnderTest(arm, bad), std::invalid_argument);
}

}  // namespace
}  // namespace tribolog
