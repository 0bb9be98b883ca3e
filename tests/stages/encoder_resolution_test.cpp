#include "stages/encoder_resolution.h"

#include <cmath>

#include <gtest/gtest.h>

namespace tribolog {
namespace {

TEST(EncoderStep, IsFoundWhereTheAngleIsQuantised) {
  for (const double step : {1e-4, 4.8e-7, 2.4e-3}) {
    std::vector<double> q;
    for (int i = 0; i < 3000; ++i) q.push_back(step * std::floor(300 * std::sin(0.01 * i)));
    EXPECT_NEAR(encoder_step_rad(q), step, 1e-9 * step);
  }
}

TEST(EncoderStep, IsFoundInDecimalLogsToo) {
  // A log printed to four digits.
  std::vector<double> q;
  for (int i = 0; i < 3000; ++i) q.push_back(std::round(1e4 * std::sin(0.003 * i)) / 1e4);
  EXPECT_NEAR(encoder_step_rad(q), 1e-4, 1e-9);
}

TEST(EncoderStep, IsZeroForContinuousAngles) {
  std::vector<double> q;
  for (int i = 0; i < 3000; ++i) q.push_back(std::sin(0.01 * i) + 1e-3 * std::sin(7.7 * i));
  EXPECT_EQ(encoder_step_rad(q), 0);
  EXPECT_EQ(encoder_step_rad({1, 1, 1}), 0);
  EXPECT_EQ(encoder_step_rad({}), 0);
}

}  // namespace
}  // namespace tribolog
