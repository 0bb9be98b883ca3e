// Clocks that are set while they are logged.

#include "ingest/log/row_clock.h"

#include <cmath>

#include <gtest/gtest.h>

namespace tribolog::row_clock_test {
namespace {

ingest::log::LogColumn even_clock(std::size_t rows, double step_s = 0.01) {
  ingest::log::LogColumn clock;
  for (std::size_t i = 0; i < rows; ++i) clock.values.push_back(step_s * static_cast<double>(i));
  return clock;
}

TEST(SetBackClock, GoesOnFromTheRowBeforeByTheUsualStep) {
  ingest::log::LogColumn clock = even_clock(1000);
  for (std::size_t i = 600; i < 1000; ++i) clock.values[i] -= 2.5;
  for (std::size_t i = 800; i < 1000; ++i) clock.values[i] -= 1.0;
  clock.values[599] = NAN;
  EXPECT_EQ(ingest::log::go_on_past_set_back(clock), 2U);
  const ingest::log::LogColumn even = even_clock(1000);
  for (std::size_t i = 0; i < 1000; ++i) {
    if (i == 599) continue;
    // The row without a time is lost from the clock too.
    const double lost_s = i < 599 ? 0 : 0.01;
    EXPECT_NEAR(clock.values[i], even.values[i] - lost_s, 1e-9) << i;
  }
  EXPECT_TRUE(std::isnan(clock.values[599]));
}

TEST(SetBackClock, LeavesJitterGapsAndStepsForwardAsTheyAre) {
  ingest::log::LogColumn clock = even_clock(1000);
  clock.values[300] -= 0.05;
  for (std::size_t i = 500; i < 1000; ++i) clock.values[i] += 40;
  const std::vector<double> before = clock.values;
  EXPECT_EQ(ingest::log::go_on_past_set_back(clock), 0U);
  EXPECT_EQ(clock.values, before);
}

TEST(SetBackClock, IsNoneWhereALogBeginsAnewOrWritersAlternate) {
  ingest::log::LogColumn anew = even_clock(1000);
  for (std::size_t i = 500; i < 1000; ++i) anew.values[i] -= 5;
  std::vector<double> before = anew.values;
  EXPECT_EQ(ingest::log::go_on_past_set_back(anew), 0U);
  EXPECT_EQ(anew.values, before);
  ingest::log::LogColumn blocks;
  for (int block = 0; block < 5; ++block) {
    for (int writer = 0; writer < 2; ++writer) {
      for (int k = 0; k < 100; ++k) {
        blocks.values.push_back(0.01 * (200 * block + 2 * k + writer));
      }
    }
  }
  before = blocks.values;
  EXPECT_EQ(ingest::log::go_on_past_set_back(blocks), 0U);
  EXPECT_EQ(blocks.values, before);
}

}  // namespace
}  // namespace tribolog::row_clock_test
