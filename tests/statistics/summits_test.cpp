// Where a signal first gets somewhere: the same as by looking at every sample, in far fewer looks.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include <gtest/gtest.h>

#include "statistics/sampled_signal.h"

namespace tribolog::summits_test {
namespace {

std::vector<double> wave(std::size_t size) {
  std::vector<double> out;
  for (std::size_t i = 0; i < size; ++i) {
    const auto x = static_cast<double>(i);
    out.push_back(std::sin(0.7 * x) + std::sin(0.013 * x) + 1e-4 * x);
  }
  return out;
}

TEST(Summits, FindWhatASearchThroughEverySampleFinds) {
  for (const std::size_t size : {1, 15, 16, 17, 256, 257, 5000}) {
    const std::vector<double> signal = wave(size);
    const statistics::Summits summits(signal);
    for (std::size_t from = 0; from <= size; from += 1 + size / 97) {
      for (const double level : {-3.0, 0.0, 1.0, 1.9, 2.3, 9.0}) {
        const auto reached = [level](double value) { return value >= level; };
        const auto begin = signal.begin() + static_cast<std::ptrdiff_t>(from);
        const auto wanted =
            static_cast<std::size_t>(std::find_if(begin, signal.end(), reached) - signal.begin());
        ASSERT_EQ(summits.first(from, reached), wanted) << size << ", " << from << ", " << level;
      }
    }
  }
}

TEST(Summits, OfALongSignalFewSamplesAreLookedAt) {
  constexpr std::size_t size = 1'000'000;
  std::vector<double> signal(size, 0.0);
  signal.back() = 1;
  const statistics::Summits summits(std::move(signal));
  std::size_t looks = 0;
  const auto reached = [&](double value) {
    ++looks;
    return value > 0.5;
  };
  EXPECT_EQ(summits.first(3, reached), size - 1);
  EXPECT_LT(looks, 200U);
}

}  // namespace
}  // namespace tribolog::summits_test
