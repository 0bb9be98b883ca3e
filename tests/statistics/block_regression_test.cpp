#include "statistics/block_regression.h"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "statistics/random_stream.h"

namespace tribolog::block_regression_test {
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
  const auto blocks = statistics::equal_blocks(std::vector<std::size_t>(rows, 0), 20);
  int covered = 0;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    statistics::RandomStream random(seed, 9);
    Eigen::VectorXd y = x * Eigen::Vector2d(3, -2);
    double noise = 0;
    for (int i = 0; i < rows; ++i) {
      noise = memory * noise + random.normal();
      y(i) += noise;
    }
    const statistics::BlockRegression fit = statistics::block_regression(x, y, blocks);
    covered += std::abs(fit.coefficients(1) + 2) <= fit.half_width(1) ? 1 : 0;
  }
  return covered;
}

TEST(BlockRegression, RecoversExactCoefficients) {
  const Eigen::MatrixXd x = line_design();
  const statistics::BlockRegression fit =
      statistics::block_regression(x, x * Eigen::Vector2d(3, -2),
                                   statistics::equal_blocks(std::vector<std::size_t>(rows, 0), 20));
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
  EXPECT_THROW(
      statistics::block_regression(Eigen::MatrixXd::Ones(1, 2), Eigen::VectorXd::Ones(1), {0}),
      std::invalid_argument);
}

TEST(BlockRegression, RowsOfABlockNeedNotFollowEachOther) {
  const Eigen::MatrixXd x = line_design();
  const Eigen::VectorXd y = x.col(1).array().sin() + 0.1 * x.col(1).array().square();
  std::vector<std::size_t> together(rows);
  for (std::size_t i = 0; i < together.size(); ++i) together[i] = i * 10 / together.size();
  const statistics::BlockRegression sorted = statistics::block_regression(x, y, together);
  // The same rows, shuffled along with their blocks.
  Eigen::MatrixXd mixed_x(x.rows(), x.cols());
  Eigen::VectorXd mixed_y(y.size());
  std::vector<std::size_t> mixed(together.size());
  std::vector<Eigen::Index> from(together.size());
  for (std::size_t i = 0; i < mixed.size(); ++i) {
    from[i] = static_cast<Eigen::Index>(i * 7 % mixed.size());  // 7 shares no factor with the rows
    mixed_x.row(static_cast<Eigen::Index>(i)) = x.row(from[i]);
    mixed_y(static_cast<Eigen::Index>(i)) = y(from[i]);
    mixed[i] = together[static_cast<std::size_t>(from[i])];
  }
  const statistics::BlockRegression scattered =
      statistics::block_regression(mixed_x, mixed_y, mixed);
  for (Eigen::Index k = 0; k < x.cols(); ++k) {
    EXPECT_NEAR(scattered.coefficients(k), sorted.coefficients(k), 1e-9);
    EXPECT_NEAR(scattered.half_width(k) / sorted.half_width(k), 1, 1e-6);
  }
  for (std::size_t i = 0; i < from.size(); ++i) {
    EXPECT_NEAR(scattered.residuals(static_cast<Eigen::Index>(i)), sorted.residuals(from[i]), 1e-9);
  }
}

TEST(EqualBlocks, StayWithinTheirGroup) {
  const auto blocks = statistics::equal_blocks({0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1}, 2);
  EXPECT_EQ(blocks, (std::vector<std::size_t>{0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 2, 2, 2}));
}

TEST(BlockRegression, AColumnWithoutEffectHasNoInterval) {
  Eigen::MatrixXd x = line_design();
  x.col(1).setZero();
  const statistics::BlockRegression fit =
      statistics::block_regression(x, Eigen::VectorXd::LinSpaced(rows, 0, 1),
                                   statistics::equal_blocks(std::vector<std::size_t>(rows, 0), 20));
  EXPECT_TRUE(std::isinf(fit.half_width(1)));
  EXPECT_TRUE(std::isinf(fit.standard_error_along(Eigen::Vector2d(0, 1))));
}

}  // namespace
}  // namespace tribolog::block_regression_test
