#include "wording/axis_scale.h"

#include <limits>

#include <gtest/gtest.h>

namespace tribolog::figures::axis_scale_test {
namespace {

TEST(AxisScale, PrefixKeepsNumbersShort) {
  EXPECT_EQ(wording::prefixed("rad", 100e-6).unit, "µrad");
  EXPECT_EQ(wording::prefixed("rad", 2e-3).unit, "mrad");
  EXPECT_EQ(wording::prefixed("rad", 0.5).unit, "rad");
  EXPECT_EQ(wording::prefixed("N·m", 4.0).unit, "N·m");
  EXPECT_EQ(wording::prefixed("N·m", 0.03).unit, "mN·m");
  EXPECT_EQ(wording::prefixed("N·m", -0.03).unit, "mN·m");
  EXPECT_EQ(wording::prefixed("rad", 3e-8).unit, "nrad");
  EXPECT_DOUBLE_EQ(wording::prefixed("rad", 100e-6)(100e-6), 100.0);
}

TEST(AxisScale, ValuesWithoutSizeKeepTheUnit) {
  EXPECT_EQ(wording::prefixed("rad", 0.0).unit, "rad");
  EXPECT_EQ(wording::prefixed("rad", std::numeric_limits<double>::quiet_NaN()).unit, "rad");
  EXPECT_EQ(wording::prefixed("rad", std::numeric_limits<double>::infinity()).unit, "rad");
  EXPECT_EQ(wording::prefixed("rad", 1e-300).unit, "nrad");
}

TEST(AxisScale, FlatCurveLosesARoundLevel) {
  const wording::AxisScale scale = wording::levelled("N·m", wording::Extent{4.7657, 4.7663, false});
  EXPECT_DOUBLE_EQ(scale.offset, 4.766);
  EXPECT_EQ(scale.unit, "mN·m");
  EXPECT_NEAR(scale(4.7663), 0.3, 1e-9);
  EXPECT_EQ(wording::axis_title("driving torque T", scale, "N·m"),
            "driving torque T − 4.766 N·m [mN·m]");
}

TEST(AxisScale, LevelBelowZeroIsAdded) {
  const wording::AxisScale scale =
      wording::levelled("N·m", wording::Extent{-4.7663, -4.7657, false});
  EXPECT_EQ(wording::axis_title("T", scale, "N·m"), "T + 4.766 N·m [mN·m]");
}

TEST(AxisScale, OrdinaryCurveKeepsItsLevel) {
  const wording::AxisScale scale = wording::levelled("N·m", wording::Extent{3.0, 4.8, false});
  EXPECT_EQ(scale.offset, 0.0);
  EXPECT_EQ(wording::axis_title("driving torque T", scale, "N·m"), "driving torque T [N·m]");
  EXPECT_EQ(wording::levelled("N·m", wording::Extent{}).unit, "N·m");
}

TEST(AxisScale, RightAngleIsNinetyDegrees) {
  EXPECT_DOUBLE_EQ(wording::degrees()(1.5707963267948966), 90.0);
}

}  // namespace
}  // namespace tribolog::figures::axis_scale_test
