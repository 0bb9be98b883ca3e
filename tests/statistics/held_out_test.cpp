// Errors at held-out groups, against fits made one by one, and the comparison of two models.

#include "statistics/held_out.h"

#include <cmath>

#include <gtest/gtest.h>

#include "statistics/linear_systems.h"

namespace tribolog::held_out_test {
namespace {

using statistics::difference;
using statistics::ErrorDifference;
using statistics::held_out_errors;

struct Rows {
  Eigen::MatrixXd columns;
  Eigen::VectorXd y;
  std::vector<std::size_t> group;
};

/// A parabola with a wave that no column describes; columns up to a power of the abscissa, of
/// very different sizes.
Rows rows_of_a_parabola(Eigen::Index powers, double wave) {
  const std::vector<std::size_t> sizes{7, 4, 9, 5, 6};
  Rows rows;
  for (std::size_t g = 0; g < sizes.size(); ++g) rows.group.insert(rows.group.end(), sizes[g], g);
  const auto n = static_cast<Eigen::Index>(rows.group.size());
  rows.columns.resize(n, powers + 1);
  rows.y.resize(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const double x = 100.0 + 10.0 * static_cast<double>(i);
    for (Eigen::Index p = 0; p <= powers; ++p) {
      rows.columns(i, p) = std::pow(x, static_cast<double>(p));
    }
    rows.y(i) = 3 + 0.02 * x - 4e-5 * x * x + wave * std::sin(2.1 * static_cast<double>(i));
  }
  return rows;
}

TEST(HeldOut, EachGroupErrsAsTheFitToAllOthersDoes) {
  const Rows rows = rows_of_a_parabola(1, 0.3);
  const std::vector<double> errors = held_out_errors(rows.columns, rows.y, rows.group);
  ASSERT_EQ(errors.size(), 5U);
  for (std::size_t g = 0; g < errors.size(); ++g) {
    std::vector<Eigen::Index> kept;
    std::vector<Eigen::Index> held;
    for (std::size_t i = 0; i < rows.group.size(); ++i) {
      (rows.group[i] == g ? held : kept).push_back(static_cast<Eigen::Index>(i));
    }
    const Eigen::VectorXd c =
        statistics::least_squares(rows.columns(kept, Eigen::all), Eigen::VectorXd(rows.y(kept)));
    const Eigen::VectorXd left = rows.y(held) - rows.columns(held, Eigen::all) * c;
    const double expected = left.squaredNorm() / static_cast<double>(held.size());
    EXPECT_NEAR(errors[g], expected, 1e-8 * expected) << g;
  }
}

TEST(HeldOut, TheColumnThatIsInTheDataPaysAndOneOfNothingDoesNot) {
  const auto errors = [](Eigen::Index powers) {
    const Rows rows = rows_of_a_parabola(powers, 0.05);
    return held_out_errors(rows.columns, rows.y, rows.group);
  };
  const ErrorDifference square = difference(errors(1), errors(2));
  EXPECT_GT(square.mean, square.standard_error);
  const ErrorDifference cube = difference(errors(2), errors(3));
  EXPECT_LT(cube.mean, cube.standard_error);
}

TEST(HeldOut, ADifferenceIsOfPairsAndChangesSignWithThem) {
  const std::vector<double> one{5, 7, 9, 6};
  const std::vector<double> other{4, 7, 6, 6};  // 1 0 3 0: mean 1, variance 2
  const ErrorDifference gain = difference(one, other);
  EXPECT_DOUBLE_EQ(gain.mean, 1);
  EXPECT_DOUBLE_EQ(gain.standard_error, std::sqrt(2.0 / 4));
  EXPECT_DOUBLE_EQ(difference(other, one).mean, -1);
  EXPECT_TRUE(std::isinf(difference({2}, {1}).standard_error));  // a single group shows nothing
  EXPECT_DOUBLE_EQ(statistics::root_mean({9, 16}), std::sqrt(12.5));
}

}  // namespace
}  // namespace tribolog::held_out_test
