#pragma once
// Nonlinear least squares through Eigen's port of MINPACK, with the one interface our fits need.

#include <functional>

#include <Eigen/Core>

namespace tribolog {

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

}  // namespace tribolog
