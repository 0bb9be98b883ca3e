// Which of two fits leaves less: sure where it is, and not sure where it is chance.

#include "statistics/fit_comparison.h"

#include <gtest/gtest.h>

#include "statistics/random_stream.h"

namespace tribolog::fit_comparison_test {
namespace {

constexpr Eigen::Index rows = 1000;
constexpr Eigen::Index rows_of_a_block = 50;
constexpr double least_gain = 0.02;

std::vector<std::size_t> blocks() {
  std::vector<std::size_t> out;
  for (Eigen::Index i = 0; i < rows; ++i) {
    out.push_back(static_cast<std::size_t>(i / rows_of_a_block));
  }
  return out;
}

Eigen::VectorXd noise(std::uint64_t seed) {
  statistics::RandomStream random(seed, 1);
  return Eigen::VectorXd::NullaryExpr(rows, [&](Eigen::Index) { return random.normal(); });
}

TEST(RivalFits, ALackOfFitInAllBlocksIsSeenAndOnlyThatWay) {
  const Eigen::VectorXd good = noise(1);
  Eigen::VectorXd bad = good;
  for (Eigen::Index i = 0; i < rows; ++i) bad(i) += i % 2 == 0 ? 0.6 : -0.6;
  EXPECT_TRUE(statistics::leaves_less(good, bad, blocks(), least_gain));
  EXPECT_FALSE(statistics::leaves_less(bad, good, blocks(), least_gain));
}

TEST(RivalFits, OneBadBlockIsNoProof) {
  const Eigen::VectorXd good = noise(2);
  Eigen::VectorXd bad = good;
  bad.head(rows_of_a_block) *= 10;
  EXPECT_FALSE(statistics::leaves_less(good, bad, blocks(), least_gain));
}

TEST(RivalFits, ChanceWinsInFewCases) {
  constexpr int cases = 200;
  int won = 0;
  for (int k = 0; k < cases; ++k) {
    won += statistics::leaves_less(noise(100 + 2 * k), noise(101 + 2 * k), blocks(), 0) ? 1 : 0;
  }
  EXPECT_LE(won, cases / 20);
}

TEST(RivalFits, NobodyBeatsHimself) {
  const Eigen::VectorXd residuals = noise(3);
  EXPECT_FALSE(statistics::leaves_less(residuals, residuals, blocks(), 0));
}

}  // namespace
}  // namespace tribolog::fit_comparison_test
