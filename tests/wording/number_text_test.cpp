#include "wording/number_text.h"

#include <limits>

#include <gtest/gtest.h>

namespace tribolog::figures::number_text_test {
namespace {

const wording::AxisScale newton_metre{1.0, "N·m"};

TEST(NumberText, SignificantDigits) {
  EXPECT_EQ(wording::significant(3.88318, 4), "3.883");
  EXPECT_EQ(wording::significant(-22.23187, 4), "−22.23");
  EXPECT_EQ(wording::significant(0.0031, 3), "0.00310");
  EXPECT_EQ(wording::significant(0.0, 3), "0");
  EXPECT_EQ(wording::significant(1234.5, 3), "1230");
  EXPECT_EQ(wording::significant(1e300, 3), "1.00×10³⁰⁰");
}

TEST(NumberText, ValueEndsWhereItsIntervalBegins) {
  EXPECT_EQ(wording::with_interval(statistics::symmetric_estimate(3.883186, 0.00431), newton_metre),
            "3.8832 ± 0.0043 N·m");
  EXPECT_EQ(wording::with_interval(statistics::symmetric_estimate(80.0, 12.0),
                                   wording::AxisScale{1.0, "kg"}),
            "80 ± 12 kg");
  EXPECT_EQ(wording::rounded(statistics::symmetric_estimate(3.883186, 0.00431), newton_metre),
            "3.883 N·m");
}

TEST(NumberText, DegreesTakeNoSpace) {
  EXPECT_EQ(
      wording::with_interval(statistics::symmetric_estimate(-0.388019, 1e-4), wording::degrees()),
      "−22.2319° ± 0.0057°");
  EXPECT_EQ(wording::with_unit(-0.388019, wording::degrees(), 4), "−22.23°");
}

TEST(NumberText, LopsidedIntervalIsShownByItsEnds) {
  const statistics::Estimate estimate{1.0, 0.9, 1.4, {}};
  EXPECT_EQ(wording::with_interval(estimate, newton_metre), "1.00 N·m (0.90 to 1.40)");
}

TEST(NumberText, WithoutAnInterval) {
  EXPECT_EQ(
      wording::with_interval(statistics::Estimate{3.883186, 3.883186, 3.883186, {}}, newton_metre),
      "3.8832 N·m");
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(wording::with_interval(statistics::Estimate{nan, nan, nan, {}}, newton_metre),
            "unknown");
  EXPECT_EQ(
      wording::with_interval(statistics::Estimate{2.0, -infinity, infinity, {}}, newton_metre),
      "2.0000 N·m");
  EXPECT_EQ(wording::significant(infinity, 3), "unknown");
}

TEST(NumberText, ComputersRoundingIsNoResult) {
  EXPECT_EQ(wording::with_unit(-4e-16, wording::AxisScale{1e9, "nN·m"}, 3), "0 nN·m");
  EXPECT_EQ(wording::with_interval(statistics::symmetric_estimate(1e-14, 1e-15),
                                   wording::AxisScale{1.0, "%"}),
            "0 %");
  EXPECT_EQ(wording::size_words(4.8e-12, wording::torque_floor_Nm, "N·m"), "below 1 µN·m");
  EXPECT_EQ(wording::size_words(0.005, wording::torque_floor_Nm, "N·m"), "5.0 mN·m");
  EXPECT_EQ(wording::size_words(1.3e-10, wording::percent_floor, "%"), "below 0.001 %");
  EXPECT_EQ(wording::size_words(0.66, wording::percent_floor, "%"), "0.66 %");
}

TEST(NumberText, ListMembersShareTheirPlace) {
  EXPECT_EQ(wording::to_place(2.6e-17, 62.83, 4), "0.00");
  EXPECT_EQ(wording::to_place(-31.114, 62.83, 4), "−31.11");
}

TEST(NumberText, RoundingUpLosesNoDigit) { EXPECT_EQ(wording::significant(0.99996, 3), "1.00"); }

TEST(NumberText, CountsAndLists) {
  EXPECT_EQ(wording::counted(1, "run"), "1 run");
  EXPECT_EQ(wording::counted(20, "run"), "20 runs");
  EXPECT_EQ(wording::listed({}), "");
  EXPECT_EQ(wording::listed({"A"}), "A");
  EXPECT_EQ(wording::listed({"A", "B", "C"}), "A, B and C");
}

}  // namespace
}  // namespace tribolog::figures::number_text_test
