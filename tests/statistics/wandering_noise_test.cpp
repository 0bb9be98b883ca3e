// A level that wanders from block to block, against one that does not.

#include "statistics/wandering_noise.h"

#include <cmath>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "statistics/order_statistics.h"
#include "statistics/random_stream.h"

namespace tribolog::wandering_noise_test {
namespace {

constexpr Eigen::Index count = 40;

/// A straight line fitted to means of 50 samples; errors of a random walk beside white ones.
struct Line {
  statistics::BlockMeans blocks;
  double slope{};  ///< Fitted; the true one is 0.

  Line(std::uint64_t seed, double walk, double white) {
    statistics::RandomStream random(seed, 0);
    Eigen::MatrixXd x(count, 2);
    Eigen::VectorXd y(count);
    double level = 0;
    for (Eigen::Index i = 0; i < count; ++i) {
      level += walk * random.normal();
      x.row(i) << 1, static_cast<double>(i);
      y(i) = level + white * random.normal();
    }
    const Eigen::MatrixXd effects = (x.transpose() * x).ldlt().solve(x.transpose());
    const Eigen::VectorXd c = effects * y;
    slope = c(1);
    blocks = {x,
              y - x * c,
              Eigen::VectorXd::Constant(count, 50),
              x.col(1),
              std::vector<std::size_t>(count, 0),
              effects};
  }
};

struct Stated {
  double held{};    ///< Share of runs whose two standard errors hold the slope.
  double found{};   ///< Share of runs in which it is told.
  double median{};  ///< Of the standard error, over that of white errors alone.
};

Stated stated(double walk, double white) {
  constexpr int runs = 300;
  Stated out;
  std::vector<double> errors;
  for (int run = 0; run < runs; ++run) {
    const Line line(static_cast<std::uint64_t>(run) + 1, walk, white);
    const auto noise = statistics::wandering_noise(line.blocks);
    const double of_white = white * line.blocks.effects.row(1).norm();
    const double error = noise ? noise->shifts.row(1).norm() : of_white;
    out.held += std::abs(line.slope) <= 2 * error ? 1.0 / runs : 0.0;
    out.found += noise ? 1.0 / runs : 0.0;
    errors.push_back(error / of_white);
  }
  out.median = statistics::median(errors);
  return out;
}

TEST(WanderingNoise, OfARandomWalkIsHeld) {
  const Stated walk = stated(0.1, 0.05);
  EXPECT_GT(walk.found, 0.95);
  EXPECT_GT(walk.held, 0.8);  // a straight line is what a walk resembles most
  EXPECT_GT(walk.median, 5);
}

TEST(WanderingNoise, OfWhiteNoiseIsHardlyMore) {
  const Stated white = stated(0, 0.05);
  EXPECT_LT(white.found, 0.15);
  EXPECT_GT(white.held, 0.93);
  EXPECT_LT(white.median, 1.01);
}

TEST(WanderingNoise, NeedsBlocksAndErrors) {
  Line line(1, 0.1, 0.05);
  line.blocks.residuals.setZero();
  EXPECT_FALSE(statistics::wandering_noise(line.blocks));
}

}  // namespace
}  // namespace tribolog::wandering_noise_test
