#include "wording/rounding.h"

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "wording/axis_scale.h"
#include "wording/torques_in.h"
#include "wording/tr.h"

namespace tribolog::report::rounding_test {
namespace {

wording::RoundedEstimate rounded(double value, double half_width,
                                 const wording::Scale& scale = {}) {
  return wording::round_by_interval({value, value - half_width, value + half_width, {}}, scale);
}

TEST(Rounding, HalfWidthHasTwoDigitsAndTheEstimateFollows) {
  EXPECT_EQ(rounded(3.88318571, 0.00431).plus_minus(), "3.8832 ± 0.0043");
  EXPECT_EQ(rounded(3.88318571, 0.00431).range(), "3.8789 … 3.8875");
  EXPECT_EQ(rounded(79.1679, 0.088).plus_minus(), "79.168 ± 0.088");
  EXPECT_EQ(rounded(0.3, 12.0).plus_minus(), "0 ± 12");
}

TEST(Rounding, ACarryInTheHalfWidthCostsADecimal) {
  EXPECT_EQ(rounded(1.23456, 0.0996).plus_minus(), "1.23 ± 0.10");
  EXPECT_EQ(rounded(1.23456, 0.0994).plus_minus(), "1.235 ± 0.099");
  EXPECT_EQ(rounded(10.0, 0.996).plus_minus(), "10.0 ± 1.0");
}

TEST(Rounding, WideIntervalsRoundToTensAndHundreds) {
  EXPECT_EQ(rounded(46542.0, 1234.0).plus_minus(), "46500 ± 1200");
}

TEST(Rounding, NegativeNumbersHaveAMinusSignAndZeroHasNone) {
  EXPECT_EQ(rounded(-0.388019, 0.00021).plus_minus(), "−0.38802 ± 0.00021");
  EXPECT_EQ(wording::fixed(-0.0001, 2), "0.00");
}

TEST(Rounding, InertiasAreReadInTheGramsThatKeepThemShort) {
  const auto shown = [](double value, double half_width) {
    return wording::in_words({value, value - half_width, value + half_width, {}},
                             wording::quantity_scale("kg·m²", value));
  };
  EXPECT_EQ(shown(24.65, 0.08), "24.650 ± 0.080\u00a0kg·m²");
  EXPECT_EQ(shown(1.6834e-3, 5.2e-6), "1.6834 ± 0.0052\u00a0g·m²");
  EXPECT_EQ(shown(1.96e-4, 4e-6), "0.1960 ± 0.0040\u00a0g·m²");
  EXPECT_EQ(shown(2.5e-6, 1e-7), "2.50 ± 0.10\u00a0mg·m²");
  EXPECT_EQ(wording::inertia_scale(0).unit, "kg·m²");
}

TEST(Rounding, DegreesTurnTheIntervalAlong) {
  const statistics::Estimate link = statistics::scaled({-0.388019, -0.389, -0.387, {}}, -1.0);
  const wording::RoundedEstimate text = wording::round_by_interval(link, wording::degree_scale());
  EXPECT_EQ(text.plus_minus(), "22.232 ± 0.057");
  EXPECT_EQ(text.range(), "22.173 … 22.288");
}

TEST(Rounding, ALopsidedIntervalIsGivenByItsEndsOnly) {
  const wording::RoundedEstimate text = wording::round_by_interval({1.0, 0.9, 1.4, {}}, {});
  EXPECT_EQ(text.plus_minus(), "1.00");
  EXPECT_EQ(text.range(), "0.90 … 1.40");
}

TEST(Rounding, NoMoreThanSevenDigits) {
  const wording::RoundedEstimate text = rounded(3.883185714321, 1e-12);
  EXPECT_EQ(text.plus_minus(), "3.883186 ± < 0.000001");
  EXPECT_EQ(text.range(), "");
}

TEST(Rounding, BelowResolutionIsZero) {
  EXPECT_EQ(rounded(1.132e-14, 2e-16, {1e6, "µN·m"}).plus_minus(), "0");
  EXPECT_EQ(wording::in_words({3.7e-12, 3.6e-12, 3.8e-12, {}}, {1.0, "%"}), "0\u00a0%");
  // A wide interval about nothing is a result, and so is a small number in a unit of its own.
  EXPECT_EQ(rounded(1e-14, 2e-6, {1e6, "µN·m"}).plus_minus(), "0.0 ± 2.0");
  EXPECT_EQ(rounded(2.5e-7, 1e-8).plus_minus(), "0.000000250 ± 0.000000010");
}

TEST(Rounding, WhatIsNotKnownIsSaid) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(rounded(nan, 0.1).plus_minus(), "not identified");
  EXPECT_EQ(rounded(3.0, nan).plus_minus(), "3.0000");
  EXPECT_EQ(rounded(3.0, 0.0).range(), "");
  EXPECT_EQ(rounded(3.0, std::numeric_limits<double>::infinity()).range(), "");
}

TEST(Rounding, SignificantDigits) {
  EXPECT_EQ(wording::significant(0.0, 3), "0");
  EXPECT_EQ(wording::significant(0.99996, 4), "1.000");
  EXPECT_EQ(wording::significant(1234567.0, 3), "1230000");
  EXPECT_EQ(wording::significant(-1.5e-9, 2), "−1.5×10⁻⁹");
  EXPECT_EQ(wording::as_stated(100.0), "100");
  EXPECT_EQ(wording::as_stated(9.81), "9.81");
}

TEST(Rounding, AZeroHasNoSign) {
  EXPECT_EQ(wording::with_plus_sign(wording::fixed(0.0004, 3)), "0.000");
  EXPECT_EQ(wording::with_plus_sign(wording::fixed(-0.0004, 3)), "0.000");
  EXPECT_EQ(wording::with_plus_sign(wording::fixed(0.0006, 3)), "+0.001");
  EXPECT_EQ(wording::with_plus_sign(wording::fixed(-0.0006, 3)), "−0.001");
  EXPECT_EQ(wording::with_plus_sign("unknown"), "unknown");
}

TEST(Rounding, CountsAreGrouped) {
  EXPECT_EQ(wording::count(0), "0");
  EXPECT_EQ(wording::count(999), "999");
  EXPECT_EQ(wording::count(140410), "140\u202f410");
  EXPECT_EQ(wording::count(8003370), "8\u202f003\u202f370");
}

TEST(Units, PrefixesKeepNumbersReadable) {
  EXPECT_EQ(wording::torque_scale(3.9).unit, "N·m");
  EXPECT_EQ(wording::torque_scale(0.0012).unit, "mN·m");
  EXPECT_EQ(wording::torque_scale(-5e-6).unit, "µN·m");
  EXPECT_EQ(wording::torque_scale(0.0).unit, "N·m");
  EXPECT_EQ(wording::radian_scale(1e-4).unit, "mrad");
  EXPECT_EQ(wording::stiffness_scale(4.66e6).unit, "kN·m/rad");
}

TEST(Units, OfACurrentHavePrefixesToo) {
  EXPECT_EQ(wording::quantity_scale("A", 0.012).unit, "mA");
  EXPECT_EQ(wording::quantity_scale("A/rad", 4.66e6).unit, "kA/rad");
  EXPECT_EQ(wording::quantity_scale("A·s/rad", 0.01).factor, 1e3);
  EXPECT_EQ(wording::quantity_scale("A·s²/rad", 2e-6).unit, "µA·s²/rad");
}

// While they are in amperes no text says newton metres; the torque constant's own unit stays.
TEST(Units, OfTorquesAreAmperesWhereThoseAreMeant) {
  const auto all = [] {
    return std::vector{
        wording::torque_scale(0.01).unit,   wording::inertia_scale(0.002).unit,
        wording::stiffness_scale(20).unit,  wording::with_unit("2", "N·m/A"),
        wording::prefixed("N·m", 0.2).unit, wording::tr("{torque} mN·m", {{"torque", "N·m"}})};
  };
  {
    const wording::TorquesIn unit(joint::TorqueUnit::ampere);
    EXPECT_EQ(all(), (std::vector<std::string>{"mA", "mA·s²/rad", "A/rad", "2\u00a0N·m/A", "mA",
                                               "N·m mA"}))
        << "a value stays as it is";
  }
  EXPECT_EQ(all(), (std::vector<std::string>{"mN·m", "g·m²", "N·m/rad", "2\u00a0N·m/A", "mN·m",
                                             "N·m mN·m"}));
}

TEST(Rounding, InWords) {
  EXPECT_EQ(wording::in_words({3.88318571, 3.87888, 3.88749, {}}, wording::plain_scale("N·m")),
            "3.8832 ± 0.0043\u00a0N·m");
  EXPECT_EQ(wording::in_words({-0.388, -0.389, -0.387, {}}, wording::degree_scale()),
            "−22.231° ± 0.057°");
}

}  // namespace
}  // namespace tribolog::report::rounding_test
