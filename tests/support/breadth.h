#pragma once
// How much of what a test could look at it does: enough to find a fault at every change, and all of
// it where TRIBOLOG_EVERY_CASE is set, as `tests/nightly.sh cases` does.

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <utility>
#include <vector>

namespace tribolog::test {

inline bool every_case() { return std::getenv("TRIBOLOG_EVERY_CASE") != nullptr; }

/// How many seeds a test of coverage takes.
inline std::size_t seeds_of(std::size_t every_change, std::size_t every_night) {
  return every_case() ? every_night : every_change;
}

/// First line of a test that waits for the night: what it looks at is looked at in part elsewhere.
#define TRIBOLOG_EACH_NIGHT()                                           \
  if (!::tribolog::test::every_case()) {                                \
    GTEST_SKIP() << "takes long: each night by tests/nightly.sh cases"; \
  }

/// At every change the first, and every so many after it.
template <typename T>
std::vector<T> some_of(std::vector<T> all, std::size_t one_of) {
  if (every_case()) return all;
  std::vector<T> some;
  for (std::size_t k = 0; k < all.size(); k += one_of) some.push_back(std::move(all[k]));
  return some;
}

/// The least share of so many 95 % intervals that must hold the truth: 4 standard errors below.
inline double least_coverage(std::size_t seeds) {
  return 0.95 - 4 * std::sqrt(0.95 * 0.05 / static_cast<double>(seeds));
}

}  // namespace tribolog::test
