// How late the torque is logged against the angle: found from starts and stops, and taken off.

#include "method/motion/torque_lag.h"

#include <cmath>

#include <gtest/gtest.h>

#include "support/paper_joint.h"

namespace tribolog::torque_lag_test {
namespace {

/// Sweeps and runs of the paper's joint with a drive's noise, its torque as the effects make it.
std::vector<joint::Recording> travels(const simulate::LogEffects& effects, std::uint64_t seed = 1) {
  simulate::Scenario s = test::noisy_paper_joint(seed);
  s.oscillation.reset();
  s.precise_sweep.reset();
  s.noise.effects = effects;
  return simulate::simulate_joint(s);
}

method::motion::TorqueLag lag_in(const std::vector<joint::Recording>& recordings) {
  std::vector<const joint::Recording*> all;
  for (const joint::Recording& r : recordings) all.push_back(&r);
  return method::motion::find_torque_lag(all, 100);
}

void expect_holds(const method::motion::TorqueLag& found, double lag_s) {
  ASSERT_TRUE(found.lag_s);
  EXPECT_LE(found.lag_s->low, lag_s);
  EXPECT_GE(found.lag_s->high, lag_s);
  EXPECT_LT(found.lag_s->half_width(), 0.5e-3 + 0.3 * std::abs(found.lag_s->value));
}

TEST(TorqueLag, IsFoundEitherWayAndZeroWhereThereIsNone) {
  for (const double lag_s : {0.0, 0.5e-3, 2e-3, 5e-3, -2e-3}) {
    const method::motion::TorqueLag found = lag_in(travels({.torque_delay_s = lag_s}));
    expect_holds(found, lag_s);
    EXPECT_EQ(found.is_clear(), lag_s != 0) << lag_s;
  }
}

TEST(TorqueLag, OfAFilterIsMostOfItsTimeConstant) {
  const double time_constant_s = 1 / (2 * 3.141592653589793 * 50);
  const method::motion::TorqueLag found = lag_in(travels({.torque_filter_Hz = 50}));
  ASSERT_TRUE(found.is_clear());
  EXPECT_GT(found.lag_s->value, 0.5 * time_constant_s);
  EXPECT_LT(found.lag_s->value, 1.1 * time_constant_s);
}

TEST(TorqueLag, TellsTheInertiaThatItIsFoundBy) {
  const simulate::Scenario s = test::paper_joint();
  const double truth = s.motor_inertia_kgm2 + s.arm_inertia_kgm2 / (100 * 100);
  const method::motion::TorqueLag found = lag_in(travels({.torque_delay_s = 2e-3}));
  ASSERT_TRUE(found.inertia_kgm2);
  EXPECT_NEAR(found.inertia_kgm2->value / truth, 1, 0.02);
}

TEST(TorqueLag, StampsInWholeMillisecondsDoNotBendTheInertia) {
  simulate::Scenario s = test::noisy_paper_joint(1);
  s.oscillation.reset();
  s.precise_sweep.reset();
  s.rough_sweep.reset();
  const double truth = s.motor_inertia_kgm2 + s.arm_inertia_kgm2 / (100 * 100);
  for (const double rate_Hz : {300.0, 400.0, 600.0, 700.0}) {
    s.constant_speed->sample_rate_Hz = rate_Hz;
    std::vector<joint::Recording> runs = simulate::simulate_joint(s);
    for (joint::Recording& r : runs) {
      for (double& t : r.t_s) t = std::round(t * 1e3) / 1e3;
    }
    const method::motion::TorqueLag found = lag_in(runs);
    ASSERT_TRUE(found.inertia_kgm2) << rate_Hz;
    EXPECT_NEAR(found.inertia_kgm2->value / truth, 1, 0.02) << rate_Hz;
  }
}

TEST(TorqueLag, SlowFiltersAreTellableFromTheStartsTheyTakeFrom) {
  EXPECT_LT(lag_in(travels({.torque_filter_Hz = 100})).lag_over_transients, 0.1);
  const method::motion::TorqueLag slow = lag_in(travels({.torque_filter_Hz = 5}));
  EXPECT_TRUE(slow.hides_inertia || slow.lag_over_transients > 0.1) << slow.lag_over_transients;
}

/// A run of a direct drive over ripple, its speed held by a controller that sees the ripple only by
/// what it does to the speed.
joint::Recording run_over_ripple(double wanted_rad_s, double from_rad) {
  constexpr double inertia = 2.5;
  constexpr double friction_Nm = 12;
  constexpr double dt_s = 1e-4;
  constexpr int steps_per_sample = 150;
  constexpr int samples = 1000;
  joint::Recording r;
  double q = from_rad;
  double speed = wanted_rad_s;
  double integral = friction_Nm;
  for (int i = 0; i < samples * steps_per_sample; ++i) {
    const double error = wanted_rad_s - speed;
    integral += 60 * error * dt_s;
    const double torque = integral + 15 * error;
    if (i % steps_per_sample == 0) {
      r.t_s.push_back(i * dt_s);
      r.q_rad.push_back(q);
      r.dq_rad_s.push_back(speed);
      r.torque_Nm.push_back(torque);
    }
    const double ripple = 0.4 * std::sin(30 * q);
    speed += (torque - friction_Nm - ripple) / inertia * dt_s;
    q += speed * dt_s;
  }
  return r;
}

TEST(TorqueLag, IsNotReadFromRippleThatAControllerFollows) {
  std::vector<joint::Recording> runs;
  for (int k = 0; k < 8; ++k) runs.push_back(run_over_ripple(0.1 + 0.02 * k, 0.3 * k));
  std::vector<const joint::Recording*> all;
  for (const joint::Recording& r : runs) all.push_back(&r);
  const method::motion::TorqueLag found = method::motion::find_torque_lag(all, 1);
  EXPECT_FALSE(found.inertia_kgm2);
  EXPECT_FALSE(found.lag_s);
  EXPECT_FALSE(found.why_not.empty());
}

TEST(TorqueLag, NeedsStartsAndStops) {
  std::vector<joint::Recording> plateaus = travels({});
  for (joint::Recording& r : plateaus) {
    const std::size_t quarter = r.size() / 4;
    for (auto* signal : {&r.t_s, &r.q_rad, &r.dq_rad_s, &r.torque_Nm}) {
      *signal = {signal->begin() + static_cast<std::ptrdiff_t>(quarter / 2),
                 signal->begin() + static_cast<std::ptrdiff_t>(quarter)};
    }
  }
  const method::motion::TorqueLag found = lag_in(plateaus);
  EXPECT_FALSE(found.lag_s);
  EXPECT_FALSE(found.why_not.empty());
}

TEST(TorqueLag, TakenOffLeavesTheTorqueBesideItsAngle) {
  joint::Recording r;
  constexpr double lag_s = 3.5e-3;
  for (int i = 0; i < 2000; ++i) {
    const double t = 1e-3 * i;
    r.t_s.push_back(t);
    r.q_rad.push_back(std::sin(t));
    r.torque_Nm.push_back(std::sin(t - lag_s));
  }
  const joint::Recording aligned = method::motion::aligned(r, lag_s);
  EXPECT_EQ(aligned.size(), r.size() - 4);  // whose torque came behind the recording's end
  for (std::size_t i = 0; i < aligned.size(); ++i) {
    EXPECT_NEAR(aligned.torque_Nm[i], aligned.q_rad[i], 2e-7);
  }
  const joint::Recording early = method::motion::aligned(r, -lag_s);
  EXPECT_EQ(early.size(), r.size() - 4);
  EXPECT_GE(early.t_s.front(), lag_s);
}

}  // namespace
}  // namespace tribolog::torque_lag_test
