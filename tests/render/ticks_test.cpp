#include <cmath>
#include <cstddef>
#include <set>

#include <gtest/gtest.h>

#include "render/layout/axis.h"

namespace tribolog::render::ticks_test {
namespace {

std::vector<std::string> labels(const layout::TickSet& ticks) {
  std::vector<std::string> out;
  for (const layout::Tick& tick : ticks.major) out.push_back(tick.label);
  return out;
}

TEST(LinearTicks, AreRoundNumbersInsideTheRange) {
  EXPECT_EQ(labels(layout::linear_ticks({-0.1, 1.1}, 8)),
            (std::vector<std::string>{"0", "0.2", "0.4", "0.6", "0.8", "1.0"}));
  EXPECT_EQ(labels(layout::linear_ticks({-320, 320}, 8)),
            (std::vector<std::string>{"−300", "−200", "−100", "0", "100", "200", "300"}));
}

TEST(LinearTicks, ReachTheEndsOfARangeThatIsRoundItself) {
  const layout::TickSet ticks = layout::linear_ticks({0.0, 0.3}, 5);
  EXPECT_EQ(ticks.major.front().value, 0.0);
  EXPECT_EQ(ticks.major.back().value, 0.3);
}

TEST(LinearTicks, TakeOutAPowerOfTenForLargeAndSmallValues) {
  const layout::TickSet large = layout::linear_ticks({0, 4.2e7}, 6);
  EXPECT_EQ(large.scale_note, "×10^{6}");
  EXPECT_EQ(large.major.back().label, "40");
  const layout::TickSet small = layout::linear_ticks({0, 4.2e-7}, 6);
  EXPECT_EQ(small.scale_note, "×10^{−9}");
  EXPECT_EQ(small.major.back().label, "400");
}

TEST(LinearTicks, StandAtWholeNumbersWhereValuesAreCounts) {
  EXPECT_EQ(labels(layout::linear_ticks({0.5, 3.5}, 8)),
            (std::vector<std::string>{"0.5", "1.0", "1.5", "2.0", "2.5", "3.0", "3.5"}));
  EXPECT_EQ(labels(layout::linear_ticks({0.5, 3.5}, 8, 1.0)),
            (std::vector<std::string>{"1", "2", "3"}));
  EXPECT_EQ(labels(layout::linear_ticks({0.5, 12.5}, 4, 1.0)),
            (std::vector<std::string>{"5", "10"}));
}

TEST(LinearTicks, SubtractALargeOffset) {
  const layout::TickSet time = layout::linear_ticks({1.7e9, 1.7e9 + 10}, 6);
  EXPECT_EQ(time.scale_note, "+ 1.7·10^{9}");
  EXPECT_EQ(labels(time), (std::vector<std::string>{"0", "2", "4", "6", "8", "10"}));
  const layout::TickSet fine = layout::linear_ticks({1e9, 1e9 + 1e-6}, 6);
  EXPECT_EQ(fine.scale_note, "×10^{−9}  + 1·10^{9}");
  for (std::size_t i = 1; i < fine.major.size(); ++i) {
    EXPECT_GT(fine.major[i].value, fine.major[i - 1].value) << "no finer than a double can tell";
  }
}

// Over many ranges: enough ticks, not too many, inside, increasing, labels distinct.
TEST(LinearTicks, HoldTheirPromiseForAnyRange) {
  for (int exponent = -280; exponent <= 280; exponent += 7) {
    for (const double low : {-3.7, -1.0, 0.0, 0.13, 1.0, 97.0}) {
      for (const double span : {1e-3, 0.9, 1.0, 2.3, 77.0}) {
        const double unit = std::pow(10.0, exponent);
        const layout::AxisRange range{low * unit, (low + span) * unit};
        for (const int most : {2, 5, 11}) {
          const layout::TickSet ticks = layout::linear_ticks(range, most);
          ASSERT_LE(ticks.major.size(), static_cast<std::size_t>(most));
          if (most >= 5) {
            ASSERT_GE(ticks.major.size(), 2U) << range.low << " " << range.high;
          }
          const auto all = labels(ticks);
          EXPECT_EQ(std::set<std::string>(all.begin(), all.end()).size(), all.size());
          double previous = range.low - unit;
          for (const layout::Tick& tick : ticks.major) {
            EXPECT_GT(tick.value, previous);
            EXPECT_GE(tick.value, range.low);
            EXPECT_LE(tick.value, range.high);
            EXPECT_LE(tick.label.size(), 12U) << tick.label;
            previous = tick.value;
          }
        }
      }
    }
  }
}

TEST(LogarithmicTicks, StandAtDecades) {
  EXPECT_EQ(labels(layout::logarithmic_ticks({1e-6, 1e3}, 12)),
            (std::vector<std::string>{"10^{−6}", "10^{−5}", "10^{−4}", "0.001", "0.01", "0.1", "1",
                                      "10", "100", "1000"}));
  EXPECT_EQ(labels(layout::logarithmic_ticks({0.9, 30}, 8)),
            (std::vector<std::string>{"1", "2", "5", "10", "20"}));
}

TEST(LogarithmicTicks, SkipDecadesWhereTheyWouldCrowd) {
  EXPECT_LE(layout::logarithmic_ticks({1e-30, 1e30}, 6).major.size(), 7U);
}

TEST(SymmetricTicks, StandAtZeroAndAtDecadesOfBothDirections) {
  EXPECT_EQ(labels(layout::symmetric_ticks({-400, 400}, 1.0003, 13)),
            (std::vector<std::string>{"−100", "−10", "−1", "0", "1", "10", "100"}));
  EXPECT_EQ(labels(layout::symmetric_ticks({-400, 400}, 1, 4)),
            (std::vector<std::string>{"−100", "0", "100"}));
  EXPECT_EQ(labels(layout::symmetric_ticks({0, 30}, 0.1, 9)),
            (std::vector<std::string>{"0", "0.1", "1", "10"}));
  // A range too short for them has plain numbers.
  EXPECT_GE(layout::symmetric_ticks({-0.4, 0.4}, 0.3, 9).major.size(), 3U);
}

TEST(TickText, WritesExactDecimals) {
  EXPECT_EQ(layout::decimal_text(-25, -1), "−2.5");
  EXPECT_EQ(layout::decimal_text(5, -3), "0.005");
  EXPECT_EQ(layout::decimal_text(12, 2), "1200");
  EXPECT_EQ(layout::decimal_text(0, -4), "0");
}

}  // namespace
}  // namespace tribolog::render::ticks_test
