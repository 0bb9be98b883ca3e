#pragma once
// Nonlinear least squares by Eigen's port of MINPACK, and the fit linearised about its solution.

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace tribolog::statistics {

// A nonlinear fit linearised about its solution: with residuals r(p) = r0 + J (p - p0), a change r*
// of the residuals moves the parameters by -J^+ r*.

/// A number that the fit gives, as a function of its parameters.
struct LinearisedReading {
  double value{};
  Eigen::VectorXd gradient;  ///< Of ln(value), or of the value, over the parameters.
  bool logarithmic{true};
};

struct LinearisedFit {
  Eigen::VectorXd parameters;  ///< p0, the solution; their meaning is the fit's own.
  Eigen::MatrixXd jacobian;    ///< J there: one row per residual, one column per parameter.
  Eigen::VectorXd residuals;   ///< r0 = model - measured.
  /// Block of each row, counted from 0, non-decreasing: residuals within a block are correlated.
  std::vector<std::size_t> block_of_row;
  /// Errors that residuals do not show: each column, times an independent standard normal number,
  /// shifts the parameters; may have no columns.
  Eigen::MatrixXd further_shifts;
};

// Nonlinear least squares by Eigen's port of MINPACK, with the one interface our fits need.

struct LeastSquaresProblem {
  Eigen::Index residuals{};
  /// Fills residuals and, if not null, their derivatives (one row per residual).
  std::function<void(const Eigen::VectorXd& p, Eigen::VectorXd& r, Eigen::MatrixXd* j)> evaluate;
};

struct LeastSquaresSolution {
  Eigen::VectorXd parameters;
  double cost{};  ///< Sum of squares / 2.
  int evaluations{};
  bool converged{};
};

/// Where the solver stops.
struct LeastSquaresLimits {
  double cost_change{1e-14};  ///< Relative.
  double step{1e-12};         ///< Relative to the parameters.
  int evaluations{200};
};

/// Levenberg-Marquardt from `start`.
LeastSquaresSolution solve_least_squares(const LeastSquaresProblem& problem,
                                         const Eigen::VectorXd& start,
                                         const LeastSquaresLimits& limits = {});

}  // namespace tribolog::statistics
