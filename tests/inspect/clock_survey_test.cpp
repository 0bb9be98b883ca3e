// What a clock is told to be, and what is wrong with it.

#include <cmath>

#include <gtest/gtest.h>

#include "inspect/survey/log_survey.h"

namespace tribolog::clock_survey_test {
namespace {

ingest::log::LogColumn clock_of(std::vector<double> values) {
  ingest::log::LogColumn column;
  column.header = {"stamp", "stamp", ""};
  column.values = std::move(values);
  return column;
}

std::vector<double> even(double step, int n) {
  std::vector<double> values;
  for (int i = 0; i < n; ++i) values.push_back(step * i);
  return values;
}

ingest::layout::ColumnMeaning without_unit() {
  ingest::layout::ColumnMeaning meaning;
  meaning.unit = "s";
  return meaning;
}

TEST(ClockSurvey, TellsTheUnitByTheSizeOfItsSteps) {
  for (const auto& [step, unit] :
       {std::pair{0.001, "s"}, std::pair{0.1, "s"}, std::pair{1.0, "ms"}, std::pair{10.0, "ms"},
        std::pair{1000.0, "us"}, std::pair{8e6, "ns"}}) {
    const inspect::survey::ClockSurvey clock =
        inspect::survey::survey_clock(clock_of(even(step, 100)), without_unit());
    EXPECT_EQ(clock.unit, unit) << step;
    EXPECT_FALSE(clock.unit_is_stated);
  }
}

TEST(ClockSurvey, AStatedUnitStands) {
  ingest::layout::ColumnMeaning meaning = without_unit();
  meaning.unit_is_stated = true;
  const inspect::survey::ClockSurvey clock =
      inspect::survey::survey_clock(clock_of(even(5, 100)), meaning);
  EXPECT_EQ(clock.unit, "s");
  EXPECT_DOUBLE_EQ(clock.rate_Hz(), 0.2);
}

TEST(ClockSurvey, CountsWhatIsWrong) {
  std::vector<double> t = even(0.01, 100);
  t[20] = t[19];                                       // stands
  t[40] = t[38];                                       // back
  for (std::size_t i = 70; i < 100; ++i) t[i] += 0.5;  // a gap behind 0.69 s
  t[90] = NAN;
  const inspect::survey::ClockSurvey clock =
      inspect::survey::survey_clock(clock_of(t), without_unit());
  EXPECT_EQ(clock.repeated, 1U);
  EXPECT_EQ(clock.back, 1U);
  EXPECT_NEAR(clock.largest_step_back_s, 0.01, 1e-12);
  ASSERT_EQ(clock.gaps.size(), 1U);
  EXPECT_NEAR(clock.gaps[0].at_s, 0.69, 1e-12);
  EXPECT_NEAR(clock.gaps[0].length_s, 0.51, 1e-12);
  EXPECT_EQ(clock.missing, 1U);
}

TEST(ClockSurvey, StuckOrEmptyIsNoClock) {
  EXPECT_EQ(inspect::survey::survey_clock(clock_of(std::vector<double>(50, 3.0)), without_unit())
                .rate_Hz(),
            0);
  EXPECT_EQ(inspect::survey::survey_clock(clock_of({}), without_unit()).rate_Hz(), 0);
  EXPECT_EQ(inspect::survey::survey_clock(clock_of({NAN, NAN}), without_unit()).missing, 2U);
}

}  // namespace
}  // namespace tribolog::clock_survey_test
