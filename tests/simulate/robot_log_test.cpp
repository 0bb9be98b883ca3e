// Joints in one log: each makes its own experiments, alone, and holds its place otherwise.

#include "simulate/robot_log.h"

#include <cmath>

#include <gtest/gtest.h>

#include "base/statement.h"
#include "friction/lugre.h"
#include "simulate/simulate_joint.h"

namespace tribolog::robot_log_test {
namespace {

simulate::Scenario joint_of(double gear_ratio, double q_peak_rad) {
  simulate::Scenario s;
  s.gear_ratio = gear_ratio;
  s.motor_inertia_kgm2 = 1e-4;
  s.load = joint::GravityLoad(10, 0.2, q_peak_rad);
  s.presliding = std::make_shared<friction::LuGreFriction>(
      friction::LuGreFriction::Parameters{100, 0.1, 1e-3, 0.1, 0.15, 5});
  simulate::SweepExperiment sweep{q_peak_rad - 0.3, q_peak_rad + 0.3, 0.2};
  sweep.sample_rate_Hz = 200;
  s.rough_sweep = sweep;
  s.oscillation = simulate::OscillationExperiment{q_peak_rad, 1e-3, 1, 2, 200, false};
  return s;
}

TEST(RobotLog, EachPartIsTheExperimentOfTheJointAlone) {
  const std::vector<simulate::Scenario> joints{joint_of(100, 0.2), joint_of(50, -0.4)};
  const simulate::RobotLog log = simulate::simulate_robot(joints);
  ASSERT_EQ(log.joints.size(), 2U);
  for (std::size_t j = 0; j < joints.size(); ++j) {
    const std::vector<joint::Recording> alone = simulate::simulate_joint(joints[j]);
    ASSERT_EQ(log.joints[j].parts.size(), alone.size());
    for (std::size_t k = 0; k < alone.size(); ++k) {
      const simulate::RobotLog::Part& part = log.joints[j].parts[k];
      EXPECT_EQ(part.role, alone[k].role);
      std::size_t i = 0;
      for (std::size_t row = 0; row < log.t_s.size(); ++row) {
        if (log.t_s[row] < part.from_s || log.t_s[row] > part.to_s) continue;
        ASSERT_LT(i, alone[k].size());
        ASSERT_EQ(log.joints[j].q_rad[row], alone[k].q_rad[i]);
        ASSERT_EQ(log.joints[j].torque_Nm[row], alone[k].torque_Nm[i]);
        ++i;
      }
      EXPECT_EQ(i, alone[k].size());
    }
  }
}

TEST(RobotLog, OneJointMovesAtATimeWithoutJumps) {
  const std::vector<simulate::Scenario> joints{joint_of(100, 0.2), joint_of(50, -0.4)};
  const simulate::RobotLog log = simulate::simulate_robot(joints);
  constexpr double fastest_rad_s = 1;
  for (std::size_t i = 1; i < log.t_s.size(); ++i) {
    ASSERT_GT(log.t_s[i], log.t_s[i - 1]);
    const double first = std::abs(log.joints[0].q_rad[i] - log.joints[0].q_rad[i - 1]);
    const double second = std::abs(log.joints[1].q_rad[i] - log.joints[1].q_rad[i - 1]);
    ASSERT_TRUE(first == 0 || second == 0) << "at " << log.t_s[i];
    ASSERT_LT(first + second, fastest_rad_s * (log.t_s[i] - log.t_s[i - 1]) + 1e-12);
  }
  // The second joint holds its load while the first one moves.
  const double q = log.joints[1].q_rad.front();
  EXPECT_NEAR(log.joints[1].torque_Nm.front(), 9.81 * 10 * 0.2 * std::cos(q + 0.4) / 50, 1e-12);
}

TEST(RobotLog, TheNoiseOfEachIsItsOwn) {
  std::vector<simulate::Scenario> joints{joint_of(100, 0.2), joint_of(100, 0.2)};
  for (simulate::Scenario& s : joints) s.noise.torque_white_Nm = 0.01;
  const simulate::RobotLog log = simulate::simulate_robot(joints);
  double product = 0;
  double square = 0;
  const std::size_t rest = 100;  // of both
  for (std::size_t i = 0; i < rest; ++i) {
    const double held = 9.81 * 10 * 0.2 * std::cos(log.joints[0].q_rad[0] - 0.2) / 100;
    const double a = log.joints[0].torque_Nm[i] - held;
    const double b = log.joints[1].torque_Nm[i] - held;
    product += a * b;
    square += a * a;
  }
  EXPECT_LT(std::abs(product), 0.4 * square);
  EXPECT_NEAR(std::sqrt(square / rest), 0.01, 0.003);
}

TEST(RobotLog, ASharedClockLosesNoSamples) {
  std::vector<simulate::Scenario> joints{joint_of(100, 0.2), joint_of(50, -0.4)};
  joints[1].noise.lost_percent = 1;
  EXPECT_THROW((void)simulate::simulate_robot(joints), Refusal);
}

}  // namespace
}  // namespace tribolog::robot_log_test
