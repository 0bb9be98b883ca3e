// How late the torque is logged against the angle: found from starts and stops, and taken off.

#include "method/motion/torque_lag.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <gtest/gtest.h>

#include "statistics/random_stream.h"
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
  for (const double lag_s : {0.0, 0.5e-3, 2e-3, 5e-3, -2e-3, 25e-3, -25e-3}) {
    const method::motion::TorqueLag found = lag_in(travels({.torque_delay_s = lag_s}));
    expect_holds(found, lag_s);
    EXPECT_EQ(found.is_clear(), lag_s != 0) << lag_s;
  }
}

TEST(TorqueLag, AndInertiaAreThoseOfAWholeLogWhereRowsWereLost) {
  const method::motion::TorqueLag whole = lag_in(travels({}));
  ASSERT_TRUE(whole.inertia_kgm2);
  for (const double percent : {0.05, 0.5, 5.0}) {
    const method::motion::TorqueLag found = lag_in(travels({.lost_percent = percent}));
    ASSERT_TRUE(found.inertia_kgm2) << percent;
    EXPECT_NEAR(found.inertia_kgm2->value, whole.inertia_kgm2->value,
                whole.inertia_kgm2->half_width())
        << percent;
    expect_holds(found, 0);
  }
}

TEST(TorqueLag, ThatGrowsWithTheClockIsToldToChange) {
  EXPECT_FALSE(lag_in(travels({})).change_s);
  EXPECT_FALSE(lag_in(travels({.torque_delay_s = 3e-3})).change_s);
  // Two channels, one on a clock of its own: late by a share of the time.
  constexpr double share = 3e-5;
  std::vector<joint::Recording> recordings = travels({});
  double before_s = 0;
  for (joint::Recording& r : recordings) {
    const double whole_s = r.t_s.back() - r.t_s.front();
    const double interval_s = r.t_s[1] - r.t_s[0];
    const std::vector<double> torque = r.torque_Nm;
    for (std::size_t i = 0; i < r.size(); ++i) {
      r.t_s[i] += before_s;
      const double late = share * r.t_s[i] / interval_s;
      const double at = std::max(0.0, static_cast<double>(i) - late);
      const auto below = static_cast<std::size_t>(at);
      r.torque_Nm[i] = std::lerp(torque[below], torque[std::min(below + 1, torque.size() - 1)],
                                 at - static_cast<double>(below));
    }
    before_s += whole_s;
  }
  const method::motion::TorqueLag found = lag_in(recordings);
  ASSERT_TRUE(found.change_s);
  EXPECT_GT(found.change_s->low, 0);
}

TEST(TorqueLag, OfAFilterIsMostOfItsTimeConstant) {
  const double time_constant_s = 1 / (2 * std::numbers::pi * 50);
  const method::motion::TorqueLag found = lag_in(travels({.torque_filter_Hz = 50}));
  ASSERT_TRUE(found.is_clear());
  EXPECT_GT(found.lag_s->value, 0.5 * time_constant_s);
  EXPECT_LT(found.lag_s->value, 1.1 * time_constant_s);
}

TEST(TorqueLag, DelayFilterAndMeanAreToldApart) {
  using method::motion::LagShape;
  for (const double lag_s : {5e-3, -5e-3}) {
    const method::motion::TorqueLag found = lag_in(travels({.torque_delay_s = lag_s}));
    EXPECT_EQ(found.shape, LagShape::delay) << lag_s;
    expect_holds(found, lag_s);
    EXPECT_LT(found.lag_s->half_width(), 0.1 * std::abs(lag_s));
  }
  for (const double cut_off_Hz : {20.0, 50.0}) {
    const method::motion::TorqueLag found = lag_in(travels({.torque_filter_Hz = cut_off_Hz}));
    EXPECT_EQ(found.shape, LagShape::filter) << cut_off_Hz;
    EXPECT_NEAR(found.lag_s->value * 2 * std::numbers::pi * cut_off_Hz, 1, 0.05) << cut_off_Hz;
  }
  for (const double window_s : {10e-3, 20e-3, 50e-3}) {
    const method::motion::TorqueLag found = lag_in(travels({.torque_mean_s = window_s}));
    EXPECT_EQ(found.shape, LagShape::moving_mean) << window_s;
    EXPECT_NEAR(found.lag_s->value, window_s / 2, 0.05 * window_s) << window_s;
    // A box of that width has the variance of a filter with this time constant.
    EXPECT_NEAR(found.rounds_as_filter_s, window_s / std::sqrt(12.0), 0.05 * window_s);
  }
  EXPECT_FALSE(lag_in(travels({})).shape);
}

TEST(TorqueLag, LongerThanStartsAndStopsIsNoReasonToFail) {
  for (const double window_s : {0.1, 0.3}) {
    const method::motion::TorqueLag found = lag_in(travels({.torque_mean_s = window_s}));
    if (found.lag_s) expect_holds(found, window_s / 2);
  }
  // Of starts alone that are over before the torque shows them nothing is left to fit.
  std::vector<joint::Recording> starts = travels({.torque_delay_s = 0.15});
  for (joint::Recording& r : starts) {
    const std::size_t kept = std::min<std::size_t>(r.size(), 160);
    for (auto* signal : {&r.t_s, &r.q_rad, &r.dq_rad_s, &r.torque_Nm}) signal->resize(kept);
  }
  EXPECT_FALSE(lag_in(starts).is_clear());
}

// What the bristle does at starts is as large there: it must not be taken for a filter.
TEST(TorqueLag, AShortDelayIsNoFilter) {
  for (const double lag_s : {1e-3, 2e-3, -1e-3, -2e-3}) {
    EXPECT_NE(lag_in(travels({.torque_delay_s = lag_s})).shape, method::motion::LagShape::filter)
        << lag_s;
  }
}

/// Runs of a motor whose link hangs on a spring: it starts and stops without a jerk, its torque
/// moves both.
std::vector<joint::Recording> runs_of_an_elastic_gear(double frequency_Hz, double noise_Nm) {
  constexpr double motor = 1e-4;
  constexpr double link = 3e-4;
  constexpr double start_s = 0.25;
  constexpr double dt_s = 1e-5;
  constexpr int steps_per_sample = 100;
  const double stiffness = link * std::pow(2 * std::numbers::pi * frequency_Hz, 2);
  const double damping = 0.05 * std::sqrt(stiffness * link);
  statistics::RandomStream random(1, 1);
  std::vector<joint::Recording> runs;
  for (int run = 0; run < 8; ++run) {
    const double speed = (run % 2 == 0 ? 1 : -1) * (20.0 + 5 * run);
    joint::Recording r;
    double twist = 0;  // of the link behind the motor
    double twist_rate = 0;
    double angle = 0;
    for (int i = 0; i < 120'000; ++i) {
      const double t = i * dt_s;
      const auto moved = [&](double since) {  // speed and acceleration
        const double share = std::clamp(since / start_s, 0.0, 1.0);
        const double left = share * (1 - share);
        return std::pair(speed * share * share * share * (10 - 15 * share + 6 * share * share),
                         speed / start_s * 30 * left * left);
      };
      const auto [up, speeding] = moved(t - 0.2);
      const auto [down, slowing] = moved(t - 0.9);
      const double pull = stiffness * twist + damping * twist_rate;
      if (i % steps_per_sample == 0) {
        r.t_s.push_back(t);
        r.q_rad.push_back(angle);
        r.dq_rad_s.push_back(up - down);
        r.torque_Nm.push_back(motor * (speeding - slowing) + pull +
                              0.05 * (speed > 0 ? 1 : -1) * (up - down != 0 ? 1 : 0) +
                              noise_Nm * random.normal());
      }
      twist_rate += dt_s * (speeding - slowing - pull / link);
      twist += dt_s * twist_rate;
      angle += dt_s * (up - down);
    }
    runs.push_back(std::move(r));
  }
  return runs;
}

TEST(TorqueLag, AnElasticGearIsNeitherDelayNorFilter) {
  const method::motion::TorqueLag found = lag_in(runs_of_an_elastic_gear(25, 1e-4));
  EXPECT_EQ(found.shape, method::motion::LagShape::elastic_gear);
  ASSERT_NE(found.rival(method::motion::LagShape::elastic_gear), nullptr);
  const double frequency_Hz =
      1 / (2 * std::numbers::pi * found.rival(method::motion::LagShape::elastic_gear)->size_s);
  // At most: three quarters of the inertia are behind the spring.
  EXPECT_NEAR(frequency_Hz, 25 / std::sqrt(0.75), 5);
  EXPECT_FALSE(lag_in(runs_of_an_elastic_gear(2000, 1e-4)).shape);
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
