#include <gtest/gtest.h>

#include "method/viscous/curve_model.h"

namespace tribolog::curve_samples_test {
namespace {

method::viscous::ConstantSpeedRun run(double speed_rad_s, double q_rad = 0) {
  method::viscous::ConstantSpeedRun r;
  r.speed_rad_s = speed_rad_s;
  r.q_rad = q_rad;
  r.mean_load = 0.5;
  return r;
}

TEST(CurveSamples, BothDirectionsAndRepetitionsOfASpeedAreOneGroup) {
  method::viscous::ViscousCurvesResult v;
  v.runs = {run(-20), run(-10.1), run(10), run(10.2), run(20.1), run(40)};
  const auto s = method::viscous::curve_samples(
      v, {method::hysteresis::Estimator::A, {-3, -2, 2.1, 2.2, 3.1, 5}});
  ASSERT_EQ(s.size(), 6U);
  EXPECT_EQ(method::viscous::group_count(s), 3U);
  EXPECT_EQ(s[0].group, 0U);
  EXPECT_EQ(s[2].group, 0U);
  EXPECT_EQ(s[3].group, 1U);
  EXPECT_EQ(s[5].group, 2U);
  EXPECT_EQ(s[1].speed_rad_s, 10.1);
  EXPECT_EQ(s[1].friction_Nm, 2);
  EXPECT_EQ(s[1].direction, -1);
}

TEST(CurveSamples, CellsOfASweepAreGroupedByAngle) {
  method::viscous::ViscousCurvesResult v;
  v.from_sweep = true;
  method::viscous::ViscousCurve curve{method::hysteresis::Estimator::A, {}};
  for (int k = 0; k < 24; ++k) {
    for (const double sign : {-1.0, 1.0}) {
      v.runs.push_back(run(sign * (1 + k % 5), 0.1 * k));
      curve.friction_Nm.push_back(sign);
    }
  }
  const auto s = method::viscous::curve_samples(v, curve);
  EXPECT_EQ(method::viscous::group_count(s), 12U);
  for (std::size_t i = 0; i < s.size(); ++i) EXPECT_EQ(s[i].group, i / 4);
}

}  // namespace
}  // namespace tribolog::curve_samples_test
