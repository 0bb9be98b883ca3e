// What friction depends on beside the speed: found again where it is, not named where it is not.

#include "method/session/session_friction.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "method/session/session_times.h"
#include "statistics/random_stream.h"

namespace tribolog::session_friction_test {
namespace {

namespace session = method::session;

constexpr double gravity_Nm = 4.0;
constexpr double q_peak_rad = -0.4;
constexpr double gear_ratio = 50;

struct Joint {
  double load{};  // of the gravity torque
  double by_angle{};
  double asymmetry{};
  double offset_Nm{};
  double change{};  // of friction over the session
  double time_constant{};
  double offset_drift_Nm{};
  double noise_Nm{0.01};
};

/// A sweep, three oscillations and runs of ascending speed, one after the other.
class Session {
 public:
  Session(const Joint& joint, std::uint64_t seed) : joint_(joint), random_(seed, 0) {}

  std::vector<joint::Recording> record() {
    move();
    whole_s_ = passed_;
    passed_ = 0;
    recordings_.clear();
    move();
    return std::move(recordings_);
  }

 private:
  static constexpr double rate_Hz = 200;

  void move() {
    begin(joint::Role::rough_sweep);
    stroke(q_peak_rad - 1.2, q_peak_rad + 1.1, 0.08);
    stroke(q_peak_rad + 1.1, q_peak_rad - 1.2, 0.08);
    for (int k = 0; k < 3; ++k) {
      begin(joint::Role::oscillation);
      oscillate();
    }
    for (int k = 0; k < 12; ++k) {
      begin(joint::Role::constant_speed);
      const double speed = 0.02 * std::pow(1.6, k);
      const double way = std::min(1.2, 3 * speed) / 2;
      stroke(q_peak_rad - way, q_peak_rad + way, speed);
      stroke(q_peak_rad + way, q_peak_rad - way, speed);
    }
  }

  void begin(joint::Role role) {
    recordings_.emplace_back();
    recordings_.back().role = role;
    recordings_.back().name = std::to_string(recordings_.size());
    t_ = 0;
  }

  [[nodiscard]] double friction(double q, double speed) const {
    const double w = gear_ratio * std::abs(speed);
    const double x = q - q_peak_rad;
    return (0.5 + 0.3 * std::exp(-std::pow(w / 4, 2)) + 0.002 * w) *
               (1 + joint_.by_angle * std::sin(2 * x)) *
               (1 + joint_.change * session::progress(passed_ / whole_s_, joint_.time_constant)) +
           joint_.load * gravity_Nm * std::abs(std::cos(x));
  }

  void add(double q, double friction_Nm, double direction) {
    joint::Recording& r = recordings_.back();
    r.t_s.push_back(t_);
    r.q_rad.push_back(q);
    r.torque_Nm.push_back(gravity_Nm * std::cos(q - q_peak_rad) + joint_.offset_Nm +
                          joint_.offset_drift_Nm * passed_ / whole_s_ +
                          friction_Nm * (direction + joint_.asymmetry) +
                          joint_.noise_Nm * random_.normal());
    t_ += 1 / rate_Hz;
    passed_ += 1 / rate_Hz;
  }

  void stroke(double from, double to, double speed) {
    const double direction = to > from ? 1 : -1;
    const auto samples = static_cast<int>(std::abs(to - from) / speed * rate_Hz);
    for (int i = 0; i < samples; ++i) {
      const double q = from + direction * speed * i / rate_Hz;
      add(q, friction(q, speed), direction);
    }
  }

  void oscillate() {
    for (int i = 0; i < 10 * rate_Hz; ++i) {
      const double phase = 2 * std::numbers::pi * i / rate_Hz;
      const double q = q_peak_rad + 1e-3 * std::sin(phase);
      add(q, 0.7 * friction(q, 0), std::cos(phase));
    }
  }

  Joint joint_;
  statistics::RandomStream random_;
  std::vector<joint::Recording> recordings_;
  double t_{};
  double passed_{};
  double whole_s_{1};
};

struct Found {
  method::gravity::CogSweepResult sweep;
  session::SessionFriction session;
};

Found examine(const Joint& joint, std::uint64_t seed = 1) {
  const std::vector<joint::Recording> recordings = Session(joint, seed).record();
  const method::motion::Sweep rough({&recordings.front()});
  Found out;
  out.sweep =
      method::gravity::identify_cog_sweep(method::gravity::SweepKind::rough, rough, gear_ratio)
          .result;
  out.session =
      session::examine_session_friction({recordings, rough, out.sweep, {}, {}, {}, gear_ratio});
  return out;
}

bool holds(const statistics::Estimate& e, double truth) {
  return e.low <= truth && truth <= e.high;
}

TEST(SessionFriction, NamesNothingOfASoundJoint) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const session::SessionFriction s = examine({}, seed).session;
    ASSERT_TRUE(s.examined);
    EXPECT_TRUE(s.load.examined && s.angle.examined && s.direction.examined && s.drift.examined);
    EXPECT_FALSE(s.load.found) << seed;
    EXPECT_FALSE(s.angle.found) << seed;
    EXPECT_FALSE(s.direction.asymmetry_found || s.direction.offset_found) << seed;
    EXPECT_FALSE(s.drift.found) << seed;
    EXPECT_FALSE(s.offset_drift.found) << seed;
  }
}

TEST(SessionFriction, IntervalsHoldTheTruth) {
  Joint joint;
  joint.load = 0.03;
  joint.asymmetry = 0.04;
  joint.offset_drift_Nm = 0.05;
  int load = 0;
  int asymmetry = 0;
  int drift = 0;
  constexpr int seeds = 30;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    const session::SessionFriction s = examine(joint, seed).session;
    EXPECT_TRUE(s.load.found && s.direction.asymmetry_found && s.offset_drift.found) << seed;
    EXPECT_FALSE(s.angle.found || s.drift.found) << seed;
    load += holds(s.load.per_load, joint.load) ? 1 : 0;
    asymmetry += holds(s.direction.asymmetry, joint.asymmetry) ? 1 : 0;
    drift += holds(s.offset_drift.change_Nm, joint.offset_drift_Nm) ? 1 : 0;
  }
  EXPECT_GE(load, 25);
  EXPECT_GE(asymmetry, 25);
  EXPECT_GE(drift, 25);
}

TEST(SessionFriction, TellsAnOffsetFromAnAsymmetry) {
  Joint joint;
  joint.offset_Nm = 0.05;
  const session::SessionFriction s = examine(joint).session;
  EXPECT_TRUE(s.direction.offset_found);
  EXPECT_TRUE(s.direction.told_apart);
  EXPECT_FALSE(s.direction.asymmetry_found);
  EXPECT_NEAR(s.direction.offset_Nm.value, 0.05, 0.01);
}

TEST(SessionFriction, TellsTheAngleFromTheLoad) {
  Joint joint;
  joint.by_angle = 0.05;
  const session::SessionFriction s = examine(joint).session;
  EXPECT_TRUE(s.angle.found);
  EXPECT_FALSE(s.load.found);
  EXPECT_NEAR(s.angle.amplitude.value, 0.05, 0.005);
}

TEST(SessionFriction, TakesWarmingUpOffTheAngle) {
  for (const double change : {-0.06, -0.2, 0.1}) {
    Joint joint;
    joint.change = change;
    joint.time_constant = 0.3;
    const Found found = examine(joint);
    const session::FrictionDrift& drift = found.session.drift;
    ASSERT_TRUE(drift.found) << change;
    EXPECT_LE(drift.low, change);
    EXPECT_GE(drift.high, change);
    EXPECT_FALSE(found.session.load.found);
    ASSERT_TRUE(found.session.rough_shift);
    const double off = found.sweep.q_peak_rad.value - q_peak_rad;
    EXPECT_GT(std::abs(off), 1e-3);  // what would be wrong without
    EXPECT_NEAR(found.session.rough_shift->q_peak_rad, off,
                found.session.rough_shift->q_peak_slack_rad + found.sweep.q_peak_rad.half_width());
    EXPECT_GT(found.session.rough_shift->q_peak_rad * off, 0);
  }
}

TEST(SessionFriction, SaysWhatItCannotSee) {
  const std::vector<joint::Recording> none;
  const method::motion::Sweep rough;
  const session::SessionFriction s =
      session::examine_session_friction({none, rough, {}, rough, {}, {}, gear_ratio});
  EXPECT_FALSE(s.examined);
  EXPECT_FALSE(s.sentence.empty());
  EXPECT_FALSE(s.drift.examined);
}

joint::Recording from_to(double from_s, double to_s) {
  joint::Recording r;
  r.t_s = {from_s, to_s};
  return r;
}

TEST(SessionTimes, ClocksThatFollowEachOtherAreOne) {
  const auto times = session::session_times({from_to(100, 110), from_to(150, 160)});
  EXPECT_TRUE(times.by_clock);
  EXPECT_DOUBLE_EQ(times.begin_s[1], 50);
  EXPECT_DOUBLE_EQ(times.whole_s, 60);
}

TEST(SessionTimes, ClocksThatEachStartAtZeroAreNot) {
  const auto times = session::session_times({from_to(0, 10), from_to(0, 30)});
  EXPECT_FALSE(times.by_clock);
  EXPECT_DOUBLE_EQ(times.begin_s[1], 10);
  EXPECT_DOUBLE_EQ(times.whole_s, 40);
}

// A law of friction that is none of those tried, in runs of ascending speed.
TEST(FrictionDrift, IsNoneOfALawThatDoesNotFit) {
  std::vector<session::FrictionLevel> levels;
  for (int k = 0; k < 20; ++k) {
    const double w = std::pow(1.35, k);
    session::FrictionLevel level;
    level.speed_rad_s = w;
    level.friction_Nm = 0.4 + 0.4 / (1 + std::pow(w / 6, 1.3)) + 0.05 * std::asinh(w / 20);
    level.standard_error_Nm = 1e-4;
    level.session_share = {0.3 + 0.03 * k};
    levels.push_back(level);
  }
  EXPECT_FALSE(session::fit_friction_drift(levels).found);
}

// Too few speeds for a law: the same speed again tells.
TEST(FrictionDrift, IsSeenInRepeatsOfASpeed) {
  std::vector<session::FrictionLevel> levels;
  for (int k = 0; k < 12; ++k) {
    session::FrictionLevel level;
    level.speed_rad_s = k % 3 + 1;
    level.session_share = {k / 11.0};
    level.friction_Nm = (0.5 + 0.1 * level.speed_rad_s) * (1 - 0.08 * k / 11.0);
    level.standard_error_Nm = 1e-3;
    levels.push_back(level);
  }
  const session::FrictionDrift drift = session::fit_friction_drift(levels);
  EXPECT_TRUE(drift.found);
  EXPECT_LE(drift.low, -0.08);
  EXPECT_GE(drift.high, -0.08);
}

}  // namespace
}  // namespace tribolog::session_friction_test
