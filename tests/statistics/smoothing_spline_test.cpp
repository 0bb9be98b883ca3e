#include "statistics/smoothing_spline.h"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include <gtest/gtest.h>

#include "statistics/random_stream.h"

namespace tribolog::smoothing_spline_test {
namespace {

statistics::CurvePoints sampled(double (*curve)(double), std::size_t n, double noise) {
  statistics::CurvePoints p;
  statistics::RandomStream random(1, 0);
  for (std::size_t i = 0; i < n; ++i) {
    const double t = static_cast<double>(i) / static_cast<double>(n - 1);
    p.t.push_back(t);
    p.y.push_back(curve(t) + noise * random.normal());
    p.error.push_back(1);
  }
  return p;
}

double sine(double t) { return std::sin(2 * std::numbers::pi * t); }

TEST(SmoothingSpline, AStraightLineIsItself) {
  const statistics::SmoothingSpline line(sampled([](double t) { return 3 - 2 * t; }, 50, 0));
  for (const double t : {-0.5, 0.0, 0.123, 1.0, 2.0}) {
    EXPECT_NEAR(line.at(t).value, 3 - 2 * t, 1e-9);
    EXPECT_NEAR(line.at(t).slope, -2, 1e-9);
  }
}

TEST(SmoothingSpline, CleanSineComesBackWithItsSlope) {
  const statistics::SmoothingSpline s(sampled(sine, 200, 0));
  for (double t = 0.1; t < 0.9; t += 0.0137) {
    EXPECT_NEAR(s.at(t).value, sine(t), 1e-7);
    EXPECT_NEAR(s.at(t).slope, 2 * std::numbers::pi * std::cos(2 * std::numbers::pi * t), 1e-4);
  }
}

TEST(SmoothingSpline, SlopeAndCurvatureAreThoseOfItsValue) {
  const statistics::SmoothingSpline s(sampled(sine, 100, 0.1));
  constexpr double h = 1e-5;
  for (double t = 0.0503; t < 0.95; t += 0.0371) {
    EXPECT_NEAR((s.at(t + h).value - s.at(t - h).value) / (2 * h), s.at(t).slope, 1e-4);
    EXPECT_NEAR((s.at(t + h).slope - s.at(t - h).slope) / (2 * h), s.at(t).curvature, 1e-2);
  }
}

TEST(SmoothingSpline, NoiseIsSmoothedAway) {
  constexpr double noise = 0.1;
  const statistics::SmoothingSpline s(sampled(sine, 2000, noise));
  double squares = 0;
  for (int i = 0; i < 1000; ++i) squares += std::pow(s.at(i / 999.0).value - sine(i / 999.0), 2);
  // Of 2000 samples, about ten parameters: noise * sqrt(10 / 2000), with room for bias.
  EXPECT_LT(std::sqrt(squares / 1000), 0.15 * noise);
  EXPECT_LT(s.degrees_of_freedom(), 40);
  EXPECT_GT(s.degrees_of_freedom(), 4);
}

TEST(SmoothingSpline, AnyNumberOfPointsIsSmoothedAlike) {
  // More points over the same motion, each with its share of noise: from some number on stretches
  // choose the weight, and what is left is what a tenth of the points leave, over the root of ten.
  constexpr double noise = 0.1;
  const auto many_turns = [](double t) { return std::sin(200 * std::numbers::pi * t); };
  const auto left = [&](std::size_t n) {
    const statistics::SmoothingSpline s(sampled(many_turns, n, noise));
    double squares = 0;
    for (int i = 0; i < 10000; ++i) {
      squares += std::pow(s.at(i / 9999.0).value - many_turns(i / 9999.0), 2);
    }
    return std::sqrt(squares / 10000);
  };
  const double few = left(20'000);
  const double many = left(200'000);
  EXPECT_LT(few, 0.3 * noise);
  EXPECT_NEAR(few / many, std::sqrt(10.0), 0.8);
}

TEST(SmoothingSpline, PointsKnownBadlyCountLess) {
  statistics::CurvePoints p = sampled(sine, 200, 1e-3);
  p.y[100] += 1;
  const double pulled =
      std::abs(statistics::SmoothingSpline(p).at(p.t[100]).value - sine(p.t[100]));
  p.error[100] = 1e3;
  EXPECT_LT(std::abs(statistics::SmoothingSpline(p).at(p.t[100]).value - sine(p.t[100])), 2e-3);
  EXPECT_GT(pulled, 2e-2);
}

TEST(SmoothingSpline, RefusesWhatIsNoCurve) {
  EXPECT_THROW(statistics::SmoothingSpline({{0, 1, 2}, {0, 1, 2}, {1, 1, 1}}),
               std::invalid_argument);
  EXPECT_THROW(statistics::SmoothingSpline({{0, 1, 1, 2}, {0, 0, 0, 0}, {1, 1, 1, 1}}),
               std::invalid_argument);
  EXPECT_THROW(statistics::SmoothingSpline({{0, 1, 2, 3}, {0, 0, 0}, {1, 1, 1, 1}}),
               std::invalid_argument);
  EXPECT_THROW(statistics::SmoothingSpline({{0, 1, 2, 3}, {0, 0, 0, 0}, {1, 1, 0, 1}}),
               std::invalid_argument);
}

}  // namespace
}  // namespace tribolog::smoothing_spline_test
