#include "stages/block_regression.h"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "simulate/random_stream.h"

namespace tribolog {
namespace {

constexpr int rows = 400;

Eigen::MatrixXd line_design() {
  Eigen::MatrixXd x(rows, 2);
  for (int i = 0; i < rows; ++i) x.row(i) << 1, std::sin(0.02 * i);
  return x;
}

/// How often the 95 % interval of the slope covers the truth, with noise of a given memory.
int coverage_of_300(double memory) {
  const Eigen::MatrixXd x = line_design();
  const auto blocks = equal_blocks(std::vector<std::size_t>(rows, 0), 20);
  int covered = 0;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    RandomStream random(seed, 9);
    Eigen::VectorXd y = x * Eigen::Vector2d(3, -2);
    double noise = 0;
    for (int i = 0; i < rows; ++i) {
      noise = memory * noise + random.normal();
      y(i) += noise;
    }
    const BlockRegression fit = block_regression(x, y, blocks);
    covered += std::abs(fit.coefficients(1) + 2) <= fit.half_width(1) ? 1 : 0;
  }
  return covered;
}

TEST(BlockRegression, RecoversExactCoefficients) {
  const Eigen::MatrixXd x = line_design();
  const BlockRegression fit = block_regression(x, x * Eigen::Vector2d(3, -2),
                                               equal_blocks(std::vector<std::size_t>(rows, 0), 20));
  EXPECT_NEAR(fit.coefficients(0), 3, 1e-13);
  EXPECT_NEAR(fit.coefficients(1), -2, 1e-13);
  EXPECT_LT(fit.residual_sd, 1e-13);
}

TEST(BlockRegression, IntervalsCoverWithWhiteAndWithCorrelatedNoise) {
  // 285 of 300 expected; 4 standard errors are 15.
  EXPECT_NEAR(coverage_of_300(0.0), 285, 15);
  // Noise with a memory of 5 samples: the textbook covariance would cover about half of the time.
  EXPECT_NEAR(coverage_of_300(0.8), 285, 22);
}

TEST(BlockRegression, RefusesTooFewRows) {
  EXPECT_THROW(block_regression(Eigen::MatrixXd::Ones(1, 2), Eigen::VectorXd::Ones(1), {0}),
               std::invalid_argument);
}

TEST(EqualBlocks, StayWithinTheirGroup) {
  const auto blocks = equal_blocks({0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1}, 2);
  EXPECT_EQ(blocks, (std::vector<std::size_t>{0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 2, 2, 2}));
}

TEST(BlockRegression, AColumnWithoutEffectHasNoInterval) {
  Eigen::MatrixXd x = line_design();
  x.col(1).setZero();
  const BlockRegression fit = block_regression(x, Eigen::VectorXd::LinSpaced(rows, 0, 1),
                                               equal_blocks(std::vector<std::size_t>(rows, 0), 20));
  EXPECT_TRUE(std::isinf(fit.half_width(1)));
  EXPECT_TRUE(std::isinf(fit.standard_error_along(Eigen::Vector2d(0, 1))));
}

}  // namespace
}  // namespace tribolog
