// Runs whose drive settles: what their inertia takes of the torque, and overshoots.

#include "method/motion/steady_runs.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "joint/recording.h"
#include "method/motion/plateaus.h"

namespace tribolog {
namespace {

constexpr double interval_s = 1e-3;
constexpr double inertia_kgm2 = 0.4;  // at the joint
constexpr double friction_Nm = 3;
constexpr double speed_rad_s = 1;

/// A joint that settles to its speed, `creep` of which is still missing at first.
joint::Recording settling_run(double creep, double torque_step_Nm = 0) {
  constexpr double time_s = 0.3;
  joint::Recording r;
  r.role = joint::Role::constant_speed;
  r.name = "run.csv";
  for (int i = 0; i < 1000; ++i) {
    const double t = i * interval_s;
    const double left = creep * std::exp(-t / time_s);
    r.t_s.push_back(t);
    r.q_rad.push_back(speed_rad_s * t + time_s * left);
    const double wave = torque_step_Nm > 0 ? 3 * torque_step_Nm * std::sin(0.7 * i) : 0;
    const double torque = friction_Nm + inertia_kgm2 * left / time_s + wave;
    r.torque_Nm.push_back(torque_step_Nm > 0 ? torque_step_Nm * std::round(torque / torque_step_Nm)
                                             : torque);
  }
  return r;
}

double mean_on_plateaus(const joint::Recording& r) {
  double sum = 0;
  double count = 0;
  for (const method::motion::Plateau& plateau : method::motion::find_plateaus(r).plateaus) {
    for (std::size_t i = plateau.first; i < plateau.last; ++i, ++count) sum += r.torque_Nm[i];
  }
  return sum / count;
}

TEST(SteadyRuns, ASpeedThatCreepsLeavesTheFrictionAlone) {
  const joint::Recording r = settling_run(-0.012);
  const method::motion::SteadyRuns steady({&r}, inertia_kgm2);
  const double bare = std::abs(mean_on_plateaus(r) / friction_Nm - 1);
  EXPECT_GT(bare, 5e-4);
  EXPECT_LT(std::abs(mean_on_plateaus(*steady.recordings().front()) / friction_Nm - 1), bare / 20);
}

TEST(SteadyRuns, WithoutAnInertiaTheyAreAsLogged) {
  const joint::Recording r = settling_run(-0.012);
  const method::motion::SteadyRuns steady({&r});
  EXPECT_EQ(steady.recordings(), (std::vector<const joint::Recording*>{&r}));
}

/// The step that the drive rounds to is that of the log, whatever was taken off it.
TEST(SteadyRuns, TheTorqueStepIsThatOfTheLog) {
  const joint::Recording r = settling_run(-0.012, 0.002);
  EXPECT_NEAR(method::motion::SteadyRuns({&r}, inertia_kgm2).torque_step_Nm(), 0.002, 1e-9);
}

/// The crest of an S-curve: it speeds up and slows down as much, and friction is what it is at the
/// crest only if the acceleration is that of its own sample.
TEST(SteadyRuns, AnAccelerationIsThatOfItsSample) {
  joint::Recording r;
  r.role = joint::Role::constant_speed;
  constexpr double half_s = 0.1;
  constexpr double share = 0.015;  // of the speed that is missing at the crest's ends
  for (int i = 0; i <= 200; ++i) {
    const double t = i * interval_s - half_s;
    const double place = t / half_s;
    r.t_s.push_back(t + half_s);
    r.q_rad.push_back(speed_rad_s * (t - share * half_s * place * place * place / 3));
    r.torque_Nm.push_back(friction_Nm - inertia_kgm2 * speed_rad_s * share * 2 * place / half_s);
  }
  const method::motion::SteadyRuns steady({&r}, inertia_kgm2);
  const joint::Recording& freed = *steady.recordings().front();
  const method::motion::MotionSegments motion = method::motion::find_plateaus(r);
  ASSERT_EQ(motion.plateaus.size(), 1U);
  for (std::size_t i = motion.plateaus[0].first; i < motion.plateaus[0].last; ++i) {
    EXPECT_NEAR(freed.torque_Nm[i], friction_Nm, 1e-6 * friction_Nm) << i;
  }
}

/// The crest of an overshoot stands still for a moment: no run at a speed of its own.
TEST(SteadyRuns, TheCrestOfAnOvershootIsNoPlateau) {
  joint::Recording r;
  r.role = joint::Role::constant_speed;
  double q = 0;
  for (int i = 0; i < 1500; ++i) {
    const double t = i * interval_s;
    double speed = speed_rad_s;
    if (t < 0.1) {
      speed *= 1.06 * t / 0.1;
    } else if (t < 0.2) {
      speed *= 1.06;
    } else if (t < 0.25) {
      speed *= 1.06 - 0.06 * (t - 0.2) / 0.05;
    }
    r.t_s.push_back(t);
    r.q_rad.push_back(q);
    q += speed * interval_s;
  }
  const method::motion::MotionSegments motion = method::motion::find_plateaus(r);
  ASSERT_EQ(motion.plateaus.size(), 1U);
  EXPECT_NEAR(motion.plateaus.front().speed_rad_s, speed_rad_s, 1e-6);
  EXPECT_EQ(motion.samples_on_plateaus + motion.samples_at_rest + motion.samples_accelerating +
                motion.samples_trimmed,
            r.size());
}

/// A staircase of speeds keeps its steps.
TEST(SteadyRuns, ShortStepsAtOtherSpeedsStay) {
  joint::Recording r;
  double q = 0;
  for (int i = 0; i < 2000; ++i) {
    r.t_s.push_back(i * interval_s);
    r.q_rad.push_back(q);
    q += (i < 300 ? 1.5 : 1.0) * speed_rad_s * interval_s;
  }
  EXPECT_EQ(method::motion::find_plateaus(r).plateaus.size(), 2U);
}

}  // namespace
}  // namespace tribolog
