#include "friction/sign_change.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace tribolog::sign_change_test {
namespace {

constexpr double resolution = 1e-14;

/// How many evaluations it takes to find it.
template <class Function>
int expect_found(const Function& f, double low, double high, double truth) {
  int calls = 0;
  const auto counted = [&](double x) {
    ++calls;
    return f(x);
  };
  const double found = friction::sign_change(counted, low, high, resolution);
  EXPECT_NEAR(found, truth, resolution);
  EXPECT_TRUE(f(found) == 0 || (f(found) < 0) == (f(high) < 0));
  return calls;
}

TEST(SignChange, IsFoundFromEitherSideAndWithFewEvaluations) {
  const double pi = std::numbers::pi;
  EXPECT_LE(expect_found([](double x) { return x - 0.3; }, 0, 1, 0.3), 6);
  EXPECT_LE(expect_found([](double x) { return 0.3 - x; }, 0, 1, 0.3), 6);
  EXPECT_LE(expect_found([](double x) { return std::cos(x); }, 0, 3, pi / 2), 15);
  EXPECT_LE(expect_found([](double x) { return std::exp(20 * x) - 2; }, 0, 1, std::log(2.0) / 20),
            30);
}

TEST(SignChange, AtAnEndOrAtAJump) {
  expect_found([](double x) { return x - 1; }, 0, 1, 1.0);
  expect_found([](double x) { return x < 0.7 ? -1.0 : 5.0; }, 0, 1, 0.7);
  expect_found([](double x) { return (x - 0.25) * (x - 0.25) * (x - 0.25); }, 0, 1, 0.25);
}

}  // namespace
}  // namespace tribolog::sign_change_test
