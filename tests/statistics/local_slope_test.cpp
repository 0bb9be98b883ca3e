// The derivative that all stages share: what it leaves as it is, and what it takes out.

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "method/motion/plateaus.h"
#include "statistics/random_stream.h"
#include "statistics/sampled_signal.h"

namespace tribolog::local_slope_test {
namespace {

using std::numbers::pi;

std::vector<double> even_times(std::size_t count, double interval_s) {
  std::vector<double> t;
  for (std::size_t i = 0; i < count; ++i) t.push_back(interval_s * static_cast<double>(i));
  return t;
}

template <class Function>
std::vector<double> over(const std::vector<double>& t, const Function& y) {
  std::vector<double> values;
  for (const double time : t) values.push_back(y(time));
  return values;
}

TEST(LocalSlope, OfALineIsItsSlopeAtAnyTimes) {
  statistics::RandomStream random(1, 1);
  std::vector<double> t{0};
  for (int i = 1; i < 200; ++i) t.push_back(t.back() + 0.01 * (0.1 + std::abs(random.normal())));
  const auto slope = statistics::local_slope(t, over(t, [](double x) { return 3 - 0.7 * x; }), 5);
  for (const double s : slope) EXPECT_NEAR(s, -0.7, 1e-10);
}

TEST(LocalSlope, HasTheGainOfATriangle) {
  constexpr double dt = 1e-3;
  constexpr std::size_t h = 20;
  const std::vector<double> t = even_times(4000, dt);
  // Largest slope of sin(w t) over w: the gain. At the cut-off it is 1/sqrt(2), at 1/(h dt) zero.
  const auto gain = [&](double frequency_Hz) {
    const double w = 2 * pi * frequency_Hz;
    const auto slope =
        statistics::local_slope(t, over(t, [&](double x) { return std::sin(w * x); }), h);
    double largest = 0;
    for (std::size_t i = h; i + h < slope.size(); ++i) {
      largest = std::max(largest, std::abs(slope[i]) / w);
    }
    return largest;
  };
  EXPECT_NEAR(gain(0.1), 1, 1e-4);
  EXPECT_NEAR(gain(statistics::cut_off_of_slope_Hz(h, dt)), std::sqrt(0.5), 5e-3);
  EXPECT_NEAR(gain(1 / (h * dt)), 0, 5e-3);
}

TEST(LocalSlope, AveragesNoiseOverBothWindows) {
  // Two means of h independent samples, h dt apart: variance 2 sd^2 / h / (h dt)^2.
  constexpr double dt = 0.01;
  constexpr std::size_t h = 10;
  const std::vector<double> t = even_times(200'000, dt);
  statistics::RandomStream random(3, 1);
  const auto slope =
      statistics::local_slope(t, over(t, [&](double) { return random.normal(); }), h);
  double squares = 0;
  for (std::size_t i = h; i + h < slope.size(); ++i) squares += slope[i] * slope[i];
  const double sd = std::sqrt(squares / static_cast<double>(slope.size() - 2 * h));
  EXPECT_NEAR(sd / (std::sqrt(2.0 / h) / (h * dt)), 1, 0.02);
}

TEST(SpeedSource, StatesWindowAndCutOffOfEveryRecording) {
  joint::Recording r;
  r.name = "a.csv";
  r.role = joint::Role::rough_sweep;
  r.t_s = even_times(100'000, 1e-3);
  r.q_rad = r.t_s;
  joint::Recording logged = r;
  logged.dq_rad_s.assign(r.size(), 1.0);
  const auto sources = method::motion::speed_sources({r, logged});
  ASSERT_EQ(sources.size(), 2U);
  EXPECT_FALSE(sources[0].is_logged);
  EXPECT_TRUE(sources[1].is_logged);
  EXPECT_EQ(sources[0].window, 200U) << "a five-hundredth of the recording";
  EXPECT_NEAR(sources[0].window_s, 0.2, 1e-9);
  EXPECT_NEAR(sources[0].cut_off_Hz, statistics::cut_off_of_slope_Hz(100, 1e-3), 1e-6);
  EXPECT_TRUE(method::motion::speed_sources({joint::Recording{}}).empty());
}

}  // namespace
}  // namespace tribolog::local_slope_test
