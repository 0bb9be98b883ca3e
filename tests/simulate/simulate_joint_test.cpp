#include "simulate/simulate_joint.h"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "support/paper_joint.h"

namespace tribolog::simulate_joint_test {
namespace {

TEST(SimulateJoint, GivesEveryExperimentAskedFor) {
  const auto recordings = simulate::simulate_joint(test::paper_joint());
  ASSERT_EQ(recordings.size(), 23U);
  EXPECT_EQ(recordings[0].role, joint::Role::rough_sweep);
  EXPECT_EQ(recordings[1].role, joint::Role::precise_sweep);
  EXPECT_EQ(recordings[2].role, joint::Role::oscillation);
  EXPECT_EQ(recordings[22].name, "constant_speed_20.csv");
  for (const joint::Recording& r : recordings) {
    EXPECT_EQ(r.q_rad.size(), r.size());
    EXPECT_EQ(r.torque_Nm.size(), r.size());
    EXPECT_EQ(r.z_rad.empty(), r.role != joint::Role::oscillation);
    EXPECT_EQ(r.rows_read, r.size());
  }
  simulate::Scenario only_sweep = test::paper_joint();
  only_sweep.precise_sweep.reset();
  only_sweep.oscillation.reset();
  only_sweep.constant_speed.reset();
  EXPECT_EQ(simulate::simulate_joint(only_sweep).size(), 1U);
}

TEST(SimulateJoint, SweepTorqueIsFrictionPlusGravityWhileSpeedIsConstant) {
  const simulate::Scenario s = test::paper_joint();
  const joint::Recording sweep = simulate::simulate_joint(s).front();
  const double speed = s.rough_sweep->speed_rad_s;
  std::size_t checked = 0;
  for (std::size_t i = 0; i < sweep.size(); ++i) {
    if (std::abs(std::abs(sweep.dq_rad_s[i]) - speed) > 1e-15) continue;
    const double gravity =
        test::true_gravity_Nm * std::cos(sweep.q_rad[i] - test::true_q_peak_rad());
    const double friction = sweep.torque_Nm[i] - gravity;
    EXPECT_NEAR(friction, s.sliding->torque_Nm(100 * sweep.dq_rad_s[i]), 1e-12);
    ++checked;
  }
  EXPECT_GT(checked, 100'000U);
}

TEST(SimulateJoint, OscillatesAtPositionsOverOneMotorTurn) {
  simulate::Scenario s = test::paper_joint();
  const auto places = simulate::spread_over_motor_turn(*s.oscillation, 8, s.gear_ratio);
  ASSERT_EQ(places.size(), 8U);
  EXPECT_EQ(places.front().centre_rad, s.oscillation->centre_rad);
  // A torque of k periods a turn sums to nothing over the positions, except for whole eighths.
  for (int k = 1; k < 8; ++k) {
    double sine = 0;
    double cosine = 0;
    for (const simulate::OscillationExperiment& e : places) {
      sine += std::sin(k * s.gear_ratio * e.centre_rad);
      cosine += std::cos(k * s.gear_ratio * e.centre_rad);
    }
    EXPECT_NEAR(std::hypot(sine, cosine), 0, 1e-10) << k;
  }
  s.further_oscillations.assign(places.begin() + 1, places.end());
  s.rough_sweep.reset();
  s.precise_sweep.reset();
  s.constant_speed.reset();
  const auto recordings = simulate::simulate_joint(s);
  ASSERT_EQ(recordings.size(), 8U);
  EXPECT_EQ(recordings.front().name, "oscillation_01.csv");
  EXPECT_EQ(recordings.back().name, "oscillation_08.csv");
  EXPECT_EQ(recordings.back().role, joint::Role::oscillation);
  s.oscillation.reset();
  EXPECT_THROW(simulate::simulate_joint(s), std::invalid_argument);
}

TEST(SimulateJoint, RampsStartAtRestAndEndBehindTheSlip) {
  simulate::Scenario s = test::paper_joint();
  s.rough_sweep.reset();
  s.precise_sweep.reset();
  s.oscillation.reset();
  s.constant_speed.reset();
  s.break_away =
      simulate::BreakAwayExperiment{test::true_q_peak_rad(), 0.2, 1.5, 0.05, 2, true, 1000};
  const auto ramps = simulate::simulate_joint(s);
  ASSERT_EQ(ramps.size(), 4U);
  for (std::size_t k = 0; k < ramps.size(); ++k) {
    const joint::Recording& r = ramps[k];
    EXPECT_EQ(r.role, joint::Role::break_away);
    EXPECT_EQ(r.name, "break_away_0" + std::to_string(k + 1) + ".csv");
    EXPECT_NEAR(r.torque_Nm.front(), test::true_gravity_Nm, 1e-6);
    EXPECT_EQ(r.dq_rad_s.front(), 0);
    const double travel = r.q_rad.back() - r.q_rad.front();
    EXPECT_EQ(travel > 0, k % 2 == 0);
    EXPECT_NEAR(std::abs(travel), 0.05, 0.005);  // ends within the travel, at a sample
    EXPECT_LT(std::abs(r.torque_Nm.back() - r.torque_Nm.front()), 1.5);
  }
  s.motor_inertia_kgm2 = 0;
  s.arm_inertia_kgm2 = 0;
  EXPECT_THROW(simulate::simulate_joint(s), std::invalid_argument);
}

TEST(SimulateJoint, RefusesExperimentsThatCannotBe) {
  simulate::Scenario s = test::paper_joint();
  s.oscillation->cycles = 0.5;
  EXPECT_THROW(simulate::simulate_joint(s), std::invalid_argument);
  s = test::paper_joint();
  s.rough_sweep->to_rad = s.rough_sweep->from_rad;
  EXPECT_THROW(simulate::simulate_joint(s), std::invalid_argument);
  s = test::paper_joint();
  s.constant_speed->motor_speeds_rad_s.push_back(-3);
  EXPECT_THROW(simulate::simulate_joint(s), std::invalid_argument);
  s = test::paper_joint();
  s.noise.torque_white_Nm = -1;
  EXPECT_THROW(simulate::simulate_joint(s), std::invalid_argument);
}

TEST(SimulateJoint, SweepsInASlowSineFromRest) {
  simulate::Scenario s = test::paper_joint();
  s.rough_sweep.reset();
  s.precise_sweep.reset();
  s.oscillation.reset();
  s.constant_speed.reset();
  s.sine_sweep = simulate::SineSweepExperiment{-0.4, 1.0, 0.1, 2.5, 100.0};
  const auto recordings = simulate::simulate_joint(s);
  ASSERT_EQ(recordings.size(), 1U);
  const joint::Recording& r = recordings.front();
  EXPECT_EQ(r.role, joint::Role::rough_sweep);
  ASSERT_EQ(r.size(), 2501U);
  const double omega = 2 * std::acos(-1.0) * 0.1;
  EXPECT_NEAR(r.q_rad.front(), -1.4, 1e-12);
  EXPECT_NEAR(r.q_rad.back(), 0.6, 1e-12);
  for (std::size_t i = 0; i < r.size(); i += 7) {
    const double speed = omega * std::sin(omega * r.t_s[i]);
    const double acceleration = omega * omega * std::cos(omega * r.t_s[i]);
    const double gravity = test::true_gravity_Nm * std::cos(r.q_rad[i] - test::true_q_peak_rad());
    const double inertia = (100 * s.motor_inertia_kgm2 + s.arm_inertia_kgm2 / 100) * acceleration;
    EXPECT_NEAR(r.dq_rad_s[i], speed, 1e-12);
    EXPECT_NEAR(r.torque_Nm[i], gravity + inertia + s.sliding->torque_Nm(100 * speed), 1e-9);
  }
}

}  // namespace
}  // namespace tribolog::simulate_joint_test
