// Segments against simulated truth, and logs in which there is nothing to cut.

#include "inspect/motion/motion_segments.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <ostream>

#include <gtest/gtest.h>

#include "inspect/long_recording.h"
#include "statistics/random_stream.h"

namespace tribolog::motion_segments_test {
namespace {

using std::numbers::pi;
using test::long_recording;
using test::LongRecording;
using test::TrueSegment;

/// What is asked for: ends within so much of a segment's length.
constexpr double end_share = 0.02;

inspect::motion::MotionKind kind_of(joint::Role role) {
  if (role == joint::Role::oscillation) return inspect::motion::MotionKind::oscillation;
  if (role == joint::Role::break_away) return inspect::motion::MotionKind::break_away_ramp;
  return inspect::motion::MotionKind::constant_speed;  // slow ones too: see manifest_proposal.h
}

const inspect::motion::MotionSegment* nearest(
    const std::vector<inspect::motion::MotionSegment>& segments, const test::TrueSegment& truth) {
  const inspect::motion::MotionSegment* best = nullptr;
  double most = 0;
  for (const inspect::motion::MotionSegment& s : segments) {
    const double common = std::min(s.to_s, truth.to_s) - std::max(s.from_s, truth.from_s);
    if (common > most) {
      most = common;
      best = &s;
    }
  }
  return best;
}

void expect_truth(const test::LongRecording& recording) {
  const std::vector<inspect::motion::MotionSegment> segments =
      inspect::motion::cut_by_motion(recording.trace);
  std::vector<const inspect::motion::MotionSegment*> found;
  for (const test::TrueSegment& truth : recording.truth) {
    SCOPED_TRACE(truth.name);
    const inspect::motion::MotionSegment* s = nearest(segments, truth);
    ASSERT_NE(s, nullptr);
    EXPECT_EQ(inspect::motion::to_string(s->kind), inspect::motion::to_string(kind_of(truth.role)));
    const double tolerance_s = end_share * (truth.to_s - truth.from_s);
    EXPECT_NEAR(s->from_s, truth.from_s, tolerance_s);
    EXPECT_NEAR(s->to_s, truth.to_s, tolerance_s);
    found.push_back(s);
  }
  for (const inspect::motion::MotionSegment& s : segments) {
    const bool is_experiment = s.kind != inspect::motion::MotionKind::rest &&
                               s.kind != inspect::motion::MotionKind::varying;
    const bool is_known = std::find(found.begin(), found.end(), &s) != found.end();
    EXPECT_TRUE(is_known || !is_experiment)
        << inspect::motion::to_string(s.kind) << " invented at " << s.from_s << " to " << s.to_s;
  }
}

TEST(MotionSegments, OneNoisyRecordingOfEverythingIsCutIntoItsExperiments) {
  for (const std::uint64_t seed : {1U, 2U, 3U})
    expect_truth(test::long_recording(test::everything(seed), 1, 2));
}

TEST(MotionSegments, AlsoWithoutNoise) {
  simulate::Scenario scenario = test::everything(1);
  scenario.noise = {};
  expect_truth(test::long_recording(scenario, 1, 2));
}

TEST(MotionSegments, AlsoAtTheRateOfASlowBus) {
  expect_truth(test::long_recording(test::everything(4), 8, 3));  // 125 Hz
}

TEST(MotionSegments, SegmentsFollowOnEachOther) {
  const test::LongRecording recording = test::long_recording(test::everything(5), 4, 2);
  const std::vector<inspect::motion::MotionSegment> segments =
      inspect::motion::cut_by_motion(recording.trace);
  for (std::size_t k = 1; k < segments.size(); ++k) {
    EXPECT_GE(segments[k].first, segments[k - 1].last);
    EXPECT_DOUBLE_EQ(segments[k].from_s, recording.trace.t_s[segments[k].first]);
  }
}

/// A sine between rests, with the steps of an encoder and white noise.
inspect::motion::AngleTrace resting_sine(double amplitude_rad, double frequency_Hz, double cycles,
                                         double rate_Hz, double step_rad, double noise_rad) {
  inspect::motion::AngleTrace trace;
  statistics::RandomStream noise(7, 0);
  const double rest_s = 5;
  const double sine_s = cycles / frequency_Hz;
  const auto n = static_cast<std::size_t>((2 * rest_s + sine_s) * rate_Hz);
  for (std::size_t i = 0; i < n; ++i) {
    const double t = static_cast<double>(i) / rate_Hz;
    const double into = std::clamp(t - rest_s, 0.0, sine_s);
    double q = amplitude_rad * std::sin(2 * pi * frequency_Hz * into) + noise_rad * noise.normal();
    if (step_rad > 0) q = step_rad * std::round(q / step_rad);
    trace.t_s.push_back(t);
    trace.q_rad.push_back(q);
  }
  return trace;
}

const inspect::motion::MotionSegment* only_motion(
    const std::vector<inspect::motion::MotionSegment>& segments) {
  const inspect::motion::MotionSegment* found = nullptr;
  for (const inspect::motion::MotionSegment& s : segments) {
    if (s.kind == inspect::motion::MotionKind::rest) continue;
    EXPECT_EQ(found, nullptr) << inspect::motion::to_string(s.kind) << " at " << s.from_s;
    found = &s;
  }
  return found;
}

struct SineCase {
  double amplitude_rad, frequency_Hz, cycles, rate_Hz, step_rad, noise_rad;
  inspect::motion::MotionKind kind;
};

void PrintTo(const SineCase& c, std::ostream* out) {
  *out << c.amplitude_rad << " rad at " << c.frequency_Hz << " Hz, " << c.cycles << " cycles, "
       << c.rate_Hz << " samples a second";
}

class Sines : public testing::TestWithParam<SineCase> {};

TEST_P(Sines, AreToldByTheirWidth) {
  const SineCase c = GetParam();
  const auto segments = inspect::motion::cut_by_motion(
      resting_sine(c.amplitude_rad, c.frequency_Hz, c.cycles, c.rate_Hz, c.step_rad, c.noise_rad));
  const inspect::motion::MotionSegment* s = only_motion(segments);
  ASSERT_NE(s, nullptr);
  EXPECT_EQ(inspect::motion::to_string(s->kind), inspect::motion::to_string(c.kind));
  const double sine_s = c.cycles / c.frequency_Hz;
  EXPECT_NEAR(s->from_s, 5, end_share * sine_s);
  EXPECT_NEAR(s->to_s, 5 + sine_s, end_share * sine_s);
  EXPECT_NEAR(s->frequency_Hz, c.frequency_Hz, 0.02 * c.frequency_Hz);
}

INSTANTIATE_TEST_SUITE_P(
    MotionSegments, Sines,
    testing::Values(SineCase{1.04, 0.1, 6, 100, 1e-4, 0, inspect::motion::MotionKind::slow_sweep},
                    SineCase{1.5, 0.02, 2, 10, 0, 0, inspect::motion::MotionKind::slow_sweep},
                    SineCase{0.5, 0.2, 5, 1000, 0, 1e-4, inspect::motion::MotionKind::slow_sweep},
                    SineCase{1.0, 0.05, 4, 3, 0, 0, inspect::motion::MotionKind::slow_sweep},
                    SineCase{1e-4, 1, 10, 1000, 5e-7, 0, inspect::motion::MotionKind::oscillation},
                    SineCase{1e-4, 1, 10, 500, 0, 1e-6, inspect::motion::MotionKind::oscillation},
                    SineCase{0.02, 2, 20, 200, 1e-4, 1e-5,
                             inspect::motion::MotionKind::oscillation}));

TEST(MotionSegments, RunsAtManySpeedsWithoutStopAreCutByTheirSpeed) {
  inspect::motion::AngleTrace trace;
  double q = 0;
  for (int i = 0; i < 5000; ++i) {
    const double speed = 0.1 * (1 + i / 1000);
    trace.t_s.push_back(0.01 * i);
    trace.q_rad.push_back(q);
    q += 0.01 * speed;
  }
  std::vector<double> speeds;
  for (const inspect::motion::MotionSegment& s : inspect::motion::cut_by_motion(trace)) {
    if (s.kind == inspect::motion::MotionKind::constant_speed) speeds.push_back(s.speed_rad_s);
  }
  ASSERT_EQ(speeds.size(), 5U);
  for (std::size_t k = 0; k < speeds.size(); ++k) {
    EXPECT_NEAR(speeds[k], 0.1 * static_cast<double>(k + 1), 1e-3);
  }
}

TEST(MotionSegments, ALogAtRestIsOneRest) {
  inspect::motion::AngleTrace trace;
  for (int i = 0; i < 1000; ++i) {
    trace.t_s.push_back(0.01 * i);
    trace.q_rad.push_back(0.3);
  }
  const auto segments = inspect::motion::cut_by_motion(trace);
  ASSERT_EQ(segments.size(), 1U);
  EXPECT_EQ(segments[0].kind, inspect::motion::MotionKind::rest);
}

TEST(MotionSegments, NoiseIsNoMotion) {
  for (const std::uint64_t seed : {1U, 2U, 3U, 4U, 5U}) {
    statistics::RandomStream noise(seed, 0);
    inspect::motion::AngleTrace trace;
    for (int i = 0; i < 5000; ++i) {
      trace.t_s.push_back(0.001 * i);
      trace.q_rad.push_back(1e-3 * noise.normal());
      trace.effort.push_back(noise.normal());
    }
    for (const inspect::motion::MotionSegment& s : inspect::motion::cut_by_motion(trace)) {
      EXPECT_TRUE(s.kind == inspect::motion::MotionKind::rest)
          << inspect::motion::to_string(s.kind) << ", seed " << seed;
    }
  }
}

TEST(MotionSegments, AMotionUnderARisingEffortIsNoRamp) {
  inspect::motion::AngleTrace trace;
  for (int i = 0; i < 6000; ++i) {  // at rest, then half a turn under an effort that rises
    const double t = 0.001 * i;
    const double moving = std::max(0.0, t - 2);
    trace.t_s.push_back(t);
    trace.q_rad.push_back(0.2 * moving * moving);
    trace.effort.push_back(10 * moving);
  }
  for (const inspect::motion::MotionSegment& s : inspect::motion::cut_by_motion(trace)) {
    EXPECT_NE(s.kind, inspect::motion::MotionKind::break_away_ramp) << s.from_s << " to " << s.to_s;
  }
}

/// A motor at 48 samples a second whose effort is noise for a third, with an encoder that does not
/// flicker: pushed up until it slips, then down without effect, then run to and fro.
inspect::motion::AngleTrace pushed_up_and_down() {
  statistics::RandomStream noise(5, 0);
  inspect::motion::AngleTrace trace;
  double q_rad = -2.4;
  for (int i = 0; i < 2400; ++i) {
    const double t = i / 48.0;
    double effort = 0;
    if (t < 15) {
      effort = 0.036 * t;
      if (t > 14.8) q_rad += 8e-3;
    } else if (t < 32) {
      effort = -0.036 * (t - 15);
    } else if (t < 41) {
      effort = 1;
      q_rad += 0.1;
    } else {
      effort = -1;
      q_rad -= 0.1;
    }
    trace.t_s.push_back(t);
    trace.q_rad.push_back(4e-4 * std::round(q_rad / 4e-4));
    trace.effort.push_back(effort + 0.12 * noise.normal());
  }
  return trace;
}

TEST(MotionSegments, RampsAreFoundInNoiseThatHidesTheirTurns) {
  std::vector<inspect::motion::MotionSegment> ramps;
  for (const auto& s : inspect::motion::cut_by_motion(pushed_up_and_down())) {
    if (s.kind == inspect::motion::MotionKind::break_away_ramp) ramps.push_back(s);
  }
  ASSERT_EQ(ramps.size(), 2U);
  EXPECT_LT(ramps[0].from_s, 1.5);
  EXPECT_NEAR(ramps[0].to_s, 15, 0.2);
  EXPECT_NEAR(ramps[0].effort_rate, 0.036, 0.003);
  EXPECT_TRUE(ramps[0].joint_slid);
  EXPECT_NEAR(ramps[1].from_s, 15, 1.5);
  EXPECT_NEAR(ramps[1].to_s, 32, 1);
  EXPECT_NEAR(ramps[1].effort_rate, -0.036, 0.003);
  EXPECT_FALSE(ramps[1].joint_slid);
}

TEST(MotionSegments, TooFewSamplesAreNothing) {
  EXPECT_TRUE(inspect::motion::cut_by_motion({}).empty());
  EXPECT_TRUE(inspect::motion::cut_by_motion({{0}, {1}, {}}).empty());
  EXPECT_LE(inspect::motion::cut_by_motion({{0, 1}, {0, 1}, {}}).size(), 1U);
}

}  // namespace
}  // namespace tribolog::motion_segments_test
