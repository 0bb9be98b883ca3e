// What may not change a segmentation: where time starts, the direction in which angles count, the
// unit of time and angle, and the unit of the effort.

#include <gtest/gtest.h>

#include "inspect/long_recording.h"

namespace tribolog::segmentation_invariance_test {
namespace {

inspect::motion::AngleTrace some_recording() {
  return test::long_recording(test::everything(11), 4, 2).trace;
}

/// Kinds and ends by sample.
void expect_same(const std::vector<inspect::motion::MotionSegment>& a,
                 const std::vector<inspect::motion::MotionSegment>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t k = 0; k < a.size(); ++k) {
    EXPECT_EQ(inspect::motion::to_string(a[k].kind), inspect::motion::to_string(b[k].kind))
        << a[k].from_s;
    EXPECT_EQ(a[k].first, b[k].first);
    EXPECT_EQ(a[k].last, b[k].last);
    EXPECT_EQ(a[k].strokes, b[k].strokes);
  }
}

TEST(Segmentation, DoesNotDependOnWhereTimeStarts) {
  const inspect::motion::AngleTrace trace = some_recording();
  inspect::motion::AngleTrace later = trace;
  for (double& t : later.t_s) t += 4096;  // a power of two: differences stay the same
  expect_same(inspect::motion::cut_by_motion(trace), inspect::motion::cut_by_motion(later));
}

TEST(Segmentation, IsThatOfTheMirroredMotion) {
  const inspect::motion::AngleTrace trace = some_recording();
  inspect::motion::AngleTrace mirrored = trace;
  for (double& q : mirrored.q_rad) q = -q;
  for (double& effort : mirrored.effort) effort = -effort;
  const auto a = inspect::motion::cut_by_motion(trace);
  const auto b = inspect::motion::cut_by_motion(mirrored);
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t k = 0; k < a.size(); ++k) {
    EXPECT_EQ(inspect::motion::to_string(a[k].kind), inspect::motion::to_string(b[k].kind))
        << a[k].from_s;
    EXPECT_EQ(a[k].direction, -b[k].direction);
    // A median takes the upper of two: the end of a ramp may move by a sample or two.
    EXPECT_NEAR(a[k].from_s, b[k].from_s, 0.02);
    EXPECT_NEAR(a[k].to_s, b[k].to_s, 0.02);
  }
}

TEST(Segmentation, DoesNotDependOnTheZeroOfTheAngle) {
  const inspect::motion::AngleTrace trace = some_recording();
  inspect::motion::AngleTrace shifted = trace;
  for (double& q : shifted.q_rad) q += 2;
  const auto a = inspect::motion::cut_by_motion(trace);
  const auto b = inspect::motion::cut_by_motion(shifted);
  // Rounding moves single samples across thresholds; kinds stay, and ends within some samples.
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t k = 0; k < a.size(); ++k) {
    EXPECT_EQ(inspect::motion::to_string(a[k].kind), inspect::motion::to_string(b[k].kind));
    EXPECT_NEAR(a[k].from_s, b[k].from_s, 0.02);
  }
}

TEST(Segmentation, DoesNotDependOnTheUnitOfTheEffort) {
  const inspect::motion::AngleTrace trace = some_recording();
  inspect::motion::AngleTrace scaled = trace;
  for (double& effort : scaled.effort) effort *= 1024;
  expect_same(inspect::motion::cut_by_motion(trace), inspect::motion::cut_by_motion(scaled));
}

TEST(Segmentation, StrokesDoNotDependOnTheScaleOfTimeAndAngle) {
  // An angle in other units without conversion, a clock ten times as fast: strokes are the same.
  // What is an oscillation or slow is said in radians and seconds, so powers of two stay small.
  inspect::motion::AngleTrace trace = some_recording();
  trace.effort.clear();
  inspect::motion::AngleTrace scaled = trace;
  for (double& q : scaled.q_rad) q *= 0.5;
  for (double& t : scaled.t_s) t *= 2;
  expect_same(inspect::motion::cut_by_motion(trace), inspect::motion::cut_by_motion(scaled));
}

}  // namespace
}  // namespace tribolog::segmentation_invariance_test
