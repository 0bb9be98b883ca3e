#include "report/elements/kept_samples.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

namespace tribolog::test::kept_samples_test {
namespace {

using report::elements::kept_samples;

struct Signals {
  std::vector<double> t, sine, noise;
};

/// Ten cycles; noise by a small generator of our own, the same everywhere.
Signals ten_cycles(std::size_t size) {
  Signals s;
  std::uint64_t seed = 1;
  for (std::size_t i = 0; i < size; ++i) {
    const double t = 10.0 * static_cast<double>(i) / static_cast<double>(size);
    seed = seed * 6364136223846793005U + 1442695040888963407U;
    s.t.push_back(t);
    s.sine.push_back(std::sin(2 * std::numbers::pi * t));
    s.noise.push_back(static_cast<double>(seed >> 40U) / (1U << 24U));
  }
  return s;
}

/// Largest distance of the samples from straight lines between the kept ones.
double worst_miss(const std::vector<double>& t, const std::vector<double>& y,
                  const std::vector<std::size_t>& kept) {
  double worst = 0;
  for (std::size_t k = 1; k < kept.size(); ++k) {
    for (std::size_t i = kept[k - 1]; i <= kept[k]; ++i) {
      const double share = (t[i] - t[kept[k - 1]]) / (t[kept[k]] - t[kept[k - 1]]);
      worst =
          std::max(worst, std::abs(y[i] - y[kept[k - 1]] - share * (y[kept[k]] - y[kept[k - 1]])));
    }
  }
  return worst;
}

TEST(KeptSamples, KeepsAllWhereThereIsRoom) {
  const Signals s = ten_cycles(50);
  const auto kept = report::elements::kept_samples(s.t, {&s.sine, &s.noise}, {}, 50);
  ASSERT_EQ(kept.size(), 50U);
  for (std::size_t i = 0; i < 50; ++i) EXPECT_EQ(kept[i], i);
}

TEST(KeptSamples, KeepsExtremesEndsAndWhatIsNeeded) {
  const Signals s = ten_cycles(10000);
  const auto kept = report::elements::kept_samples(s.t, {&s.sine, &s.noise}, {4321}, 300);
  EXPECT_EQ(kept.size(), 300U);
  EXPECT_TRUE(std::is_sorted(kept.begin(), kept.end()));
  const auto has = [&](std::size_t i) { return std::binary_search(kept.begin(), kept.end(), i); };
  const auto at = [](const std::vector<double>& y, auto it) {
    return static_cast<std::size_t>(it - y.begin());
  };
  EXPECT_TRUE(has(0) && has(9999) && has(4321));
  EXPECT_TRUE(has(at(s.noise, std::max_element(s.noise.begin(), s.noise.end()))));
  EXPECT_TRUE(has(at(s.noise, std::min_element(s.noise.begin(), s.noise.end()))));
}

TEST(KeptSamples, ASmoothCurveLooksTheSame) {
  const Signals s = ten_cycles(10000);
  const auto kept = report::elements::kept_samples(s.t, {&s.sine}, {}, 500);
  // Chords of a sine: 50 in a period miss it by pi^2 / 2 / 50^2 if they are placed evenly.
  constexpr double even = std::numbers::pi * std::numbers::pi / 2 / 50 / 50;
  EXPECT_LT(worst_miss(s.t, s.sine, kept), 2 * even);
}

TEST(KeptSamples, ALongRecordingKeepsItsShapeAndExtremesToo) {
  Signals s = ten_cycles(400000);
  s.noise[123456] = 1.5;
  for (std::size_t i = 123000; i < 123400; ++i) s.noise[i] = std::nan("");
  const auto kept = report::elements::kept_samples(s.t, {&s.sine, &s.noise}, {98765}, 500);
  EXPECT_EQ(kept.size(), 500U);
  EXPECT_TRUE(std::is_sorted(kept.begin(), kept.end()));
  for (const std::size_t i : {0U, 98765U, 123456U, 399999U}) {
    EXPECT_TRUE(std::binary_search(kept.begin(), kept.end(), i)) << i;
  }
  constexpr double even = std::numbers::pi * std::numbers::pi / 2 / 50 / 50;
  EXPECT_LT(worst_miss(s.t, s.sine, report::elements::kept_samples(s.t, {&s.sine}, {}, 500)),
            2 * even);
}

TEST(KeptSamples, ASmallSignalCountsAsMuchAsALargeOne) {
  Signals s = ten_cycles(10000);
  for (double& y : s.noise) y = 0;
  s.noise[5000] = 1e-9;  // one spike, its whole span
  const auto kept = report::elements::kept_samples(s.t, {&s.sine, &s.noise}, {}, 200);
  for (const std::size_t i : {4999U, 5000U, 5001U}) {
    EXPECT_TRUE(std::binary_search(kept.begin(), kept.end(), i)) << i;
  }
}

TEST(KeptSamples, ConstantAndUnknownSignalsDoNotMatter) {
  const Signals s = ten_cycles(1000);
  const std::vector<double> level(1000, 3.0);
  std::vector<double> unknown(1000, std::numeric_limits<double>::quiet_NaN());
  unknown[7] = std::numeric_limits<double>::infinity();
  EXPECT_EQ(report::elements::kept_samples(s.t, {&s.sine, &level, &unknown}, {}, 100),
            report::elements::kept_samples(s.t, {&s.sine}, {}, 100));
  EXPECT_EQ(report::elements::kept_samples(s.t, {&level}, {}, 100).size(), 100U);
  EXPECT_TRUE(report::elements::kept_samples({}, {}, {}, 100).empty());
}

TEST(KeptSamples, WhatIsNeededIsKeptEvenBeyondTheRoom) {
  const Signals s = ten_cycles(100);
  std::vector<std::size_t> all(100);
  for (std::size_t i = 0; i < 100; ++i) all[i] = i;
  EXPECT_EQ(report::elements::kept_samples(s.t, {&s.sine}, all, 10).size(), 100U);
}

}  // namespace
}  // namespace tribolog::test::kept_samples_test
