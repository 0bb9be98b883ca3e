#pragma once
// What fits err by on groups of data that they have not seen, and whether one errs less.

#include <cstddef>
#include <vector>

#include <Eigen/Core>

namespace tribolog::statistics {

/// Mean squared error of each group of rows, from the linear least-squares fit to the others. By
/// normal equations of scaled columns: for few columns that are not collinear.
/// @param group of each row; the rows of a group follow each other.
std::vector<double> held_out_errors(const Eigen::MatrixXd& columns, const Eigen::VectorXd& y,
                                    const std::vector<std::size_t>& group);

/// Mean of `one - other` over the groups, and its standard error: infinite for a single group.
struct ErrorDifference {
  double mean{};
  double standard_error{};
};
ErrorDifference difference(const std::vector<double>& one, const std::vector<double>& other);

/// The root of the mean of squares.
double root_mean(const std::vector<double>& squares);

}  // namespace tribolog::statistics
