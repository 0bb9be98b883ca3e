#include "history/recorded_curves.h"

#include <gtest/gtest.h>

namespace tribolog::history::recorded_curves_test {
namespace {

TEST(RecordedCurves, ReadsTheRecommendedCurveAndTheLoops) {
  const RecordedCurves c = recorded_curves(R"({
    "selection": {"recommended": "midline"},
    "viscous": {"runs": [{"speed_rad_s": -3, "torque_half_width_Nm": 0.1}, {"speed_rad_s": 4}],
                "curves": {"A": [9, 9], "midline": [-0.5, 0.6]}},
    "hysteresis": {"oscillations": [
      {"steady_loop": {"centre_rad": 0.2, "angle_from_centre_rad": [0, 1, 0], "torque_Nm": [1, 2, 3]}},
      {"steady_loop": null}, {}]}})");
  EXPECT_EQ(c.friction.estimator, "midline");
  EXPECT_EQ(c.friction.speed_rad_s, (std::vector<double>{-3, 4}));
  EXPECT_EQ(c.friction.friction_Nm, (std::vector<double>{-0.5, 0.6}));
  ASSERT_EQ(c.loops.size(), 1U);
  EXPECT_EQ(c.loops.front().torque_Nm, (std::vector<double>{1, 2, 3}));
}

TEST(RecordedCurves, WhatIsOfAnotherShapeIsNotRecorded) {
  for (
      const char* json :
      {"", "no json", "[]", "3", "{}", R"({"viscous": 3, "selection": [], "hysteresis": null})",
       R"({"viscous": {"runs": [1, 2], "curves": {"A": [1, 2]}}, "selection": {"recommended": "A"}})",
       R"({"viscous": {"runs": [{}], "curves": {"A": ["x"]}}, "selection": {"recommended": "B"}})",
       R"({"hysteresis": {"oscillations": [{"steady_loop": {"centre_rad": 1,
            "angle_from_centre_rad": [1, 2], "torque_Nm": [1, 2, 3]}}]}})"}) {
    const RecordedCurves c = recorded_curves(json);
    EXPECT_TRUE(c.friction.speed_rad_s.empty()) << json;
    EXPECT_TRUE(c.loops.empty()) << json;
  }
}

}  // namespace
}  // namespace tribolog::history::recorded_curves_test
