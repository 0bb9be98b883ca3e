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

/// Levenberg-Marquardt from `start`.
LeastSquaresSolution solve_least_squares(const LeastSquaresProblem& problem,
                                         const Eigen::VectorXd& start);

}  // namespace tribolog
