#include "method/motion/encoder_resolution.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "joint/degrees.h"
#include "statistics/random_stream.h"

namespace tribolog::encoder_resolution_test {
namespace {

/// A slow swing with a little noise, each angle put through `written`.
template <class Written>
std::vector<double> swing(double amplitude, const Written& written, double centre = 0.1) {
  statistics::RandomStream random(2, 0);
  std::vector<double> q;
  for (int i = 0; i < 3000; ++i) {
    const double noise = 1e-3 * amplitude * random.normal();
    q.push_back(written(centre + amplitude * std::sin(0.003 * i) + noise));
  }
  return q;
}

double rounded_to(double step, double value) { return step * std::round(value / step); }

TEST(CommonStep, IsFoundWhereNumbersAreQuantised) {
  for (const double step : {1e-4, 4.8e-7, 2.4e-3}) {
    std::vector<double> q;
    for (int i = 0; i < 3000; ++i) q.push_back(step * std::floor(300 * std::sin(0.01 * i)));
    EXPECT_NEAR(method::motion::common_step(q), step, 1e-9 * step);
  }
}

TEST(CommonStep, IsZeroForContinuousNumbers) {
  std::vector<double> q;
  for (int i = 0; i < 3000; ++i) q.push_back(std::sin(0.01 * i) + 1e-3 * std::sin(7.7 * i));
  EXPECT_EQ(method::motion::common_step(q), 0);
  EXPECT_EQ(method::motion::common_step({1, 1, 1}), 0);
  EXPECT_EQ(method::motion::common_step({}), 0);
}

TEST(AngleStep, OfDecimalsIsThatOfThePrint) {
  for (const double unit_rad : {1.0, joint::rad_per_degree}) {
    for (const double decimal : {1e-2, 1e-3, 1e-4, 1e-5}) {
      const double step = decimal * unit_rad;
      const method::motion::AngleStep found = method::motion::angle_step(
          swing(300 * step, [&](double q) { return rounded_to(step, q); }), 100);
      EXPECT_NEAR(found.step_rad, step, 1e-9 * step);
      EXPECT_TRUE(found.is_of_the_print);
    }
  }
}

TEST(AngleStep, OfAnEncoderAFewDecimalsWideIsBoundedByThePrint) {
  // 1,024,000 counts a turn, printed with four decimals of a degree: neighbours differ by three or
  // four of them. The angle is then stated in radians with eight digits.
  constexpr double counts_per_turn = 1024000;
  const auto written = [](double q) {
    const double of_encoder = rounded_to(2 * std::numbers::pi / counts_per_turn, q);
    const double in_degrees = rounded_to(1e-4, of_encoder * joint::degrees_per_rad);
    return rounded_to(1e-8, in_degrees * joint::rad_per_degree);
  };
  const std::vector<double> q = swing(3e-4, written);
  EXPECT_EQ(method::motion::common_step(q), 0);
  const method::motion::AngleStep found = method::motion::angle_step(q, 1);
  EXPECT_NEAR(found.step_rad, 1e-4 * joint::rad_per_degree, 1e-12);
  EXPECT_TRUE(found.is_of_the_print);
}

TEST(AngleStep, OfTheMotorsPrintedAngleIsFoundAtTheJoint) {
  constexpr double gear_ratio = 101;
  const double step = 0.01 * joint::rad_per_degree / gear_ratio;
  const method::motion::AngleStep found = method::motion::angle_step(
      swing(300 * step, [&](double q) { return rounded_to(step, q); }), gear_ratio);
  EXPECT_NEAR(found.step_rad, step, 1e-9 * step);
  EXPECT_TRUE(found.is_of_the_print);
}

TEST(AngleStep, OfACoarseEncoderUnderFinePrintIsTheEncoders) {
  const double counts = 2 * std::numbers::pi / 4096;
  const auto written = [&](double q) { return rounded_to(1e-6, rounded_to(counts, q)); };
  const method::motion::AngleStep found = method::motion::angle_step(swing(0.3, written), 1);
  EXPECT_NEAR(found.step_rad, counts, 1e-6);
  EXPECT_FALSE(found.is_of_the_print);
  // In full digits too.
  const method::motion::AngleStep exact =
      method::motion::angle_step(swing(0.3, [&](double q) { return rounded_to(counts, q); }), 100);
  EXPECT_NEAR(exact.step_rad, counts, 1e-9);
  EXPECT_FALSE(exact.is_of_the_print);
}

TEST(AngleStep, OfContinuousAnglesIsZero) {
  const auto as_it_is = [](double q) { return q; };
  for (const double amplitude : {1.0, 1e-2, 1e-4, 1e-6}) {
    for (const double centre : {0.0, 0.1}) {
      EXPECT_EQ(method::motion::angle_step(swing(amplitude, as_it_is, centre), 100).step_rad, 0)
          << amplitude;
    }
  }
  // Six digits behind the point in degrees and more are as good as continuous.
  const double fine = 1e-7 * joint::rad_per_degree;
  EXPECT_EQ(method::motion::angle_step(swing(1.0, [&](double q) { return rounded_to(fine, q); }), 1)
                .step_rad,
            0);
}

TEST(AngleStep, ARestingJointStandsOnNoGrid) {
  std::vector<double> q(5000, 0.0);
  for (int i = 0; i < 200; ++i) q.push_back(std::sin(0.01 * i + 0.005));
  EXPECT_EQ(method::motion::angle_step(q, 1).step_rad, 0);
  EXPECT_EQ(method::motion::angle_step(std::vector<double>(5000, 0.1), 1).step_rad, 0);
}

}  // namespace
}  // namespace tribolog::encoder_resolution_test
