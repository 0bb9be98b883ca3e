#pragma once
// Nonlinear least squares through Eigen's port of MINPACK, and what a fit looks like next to its
// solution.

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace tribolog::statistics {

// What a nonlinear fit looks like next to its solution: all that resampling its residuals needs.
//
// With residuals r(p) = r0 + J (p - p0), a resample r* of the residuals moves the parameters by
// -J^+ r*, with no second fit. It holds as long as the model is straight over the intervals that
// come of it.

/// A number that the fit gives, as a function of its parameters.
struct LinearisedReading {
  double value{};
  Eigen::VectorXd gradient;  ///< Of ln(value), or of the value, by the fit's parameters.
  bool logarithmic{true};
};

struct LinearisedFit {
  Eigen::VectorXd parameters;  ///< p0, the solution; their meaning is the fit's own.
  Eigen::MatrixXd jacobian;    ///< J of the residuals there: one row per sample, one column each.
  Eigen::VectorXd residuals;   ///< r0 = model - measured.
  /// Neighbouring samples that a row is the mean of.
  std::size_t samples_in_row{1};
  /// Block of each row, counted from 0, never falling: residuals of one block hang together.
  std::vector<std::size_t> block_of_row;
  /// Errors that residuals do not show: each column, times a normal number of its own, moves the
  /// parameters; may have no columns.
  Eigen::MatrixXd further_shifts;
  std::vector<LinearisedReading> readings;  ///< Of every number that is given, not of the held.
  /// Columns of the gravity torque, one of each recording; empty where none is found.
  std::vector<Eigen::Index> gravity_columns;
};

// Nonlinear least squares through Eigen's port of MINPACK, with the one interface our fits need.

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
