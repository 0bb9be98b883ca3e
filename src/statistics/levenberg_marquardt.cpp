#include "statistics/levenberg_marquardt.h"

#include <cmath>

#include <Eigen/Dense>
#include <unsupported/Eigen/NonLinearOptimization>

namespace tribolog::statistics {

namespace {

/// What Eigen's solver expects of a problem.
struct Functor {
  const LeastSquaresProblem& problem;
  Eigen::Index parameters;
  mutable Eigen::VectorXd residuals;
  mutable Eigen::MatrixXd jacobian;

  [[nodiscard]] int inputs() const { return static_cast<int>(parameters); }
  [[nodiscard]] int values() const { return static_cast<int>(problem.residuals); }
  int operator()(const Eigen::VectorXd& p, Eigen::VectorXd& r) const {
    problem.evaluate(p, r, nullptr);
    return r.allFinite() ? 0 : -1;
  }
  int df(const Eigen::VectorXd& p, Eigen::MatrixXd& j) const {
    problem.evaluate(p, residuals, &j);
    return j.allFinite() ? 0 : -1;
  }
};

}  // namespace

LeastSquaresSolution solve_least_squares(const LeastSquaresProblem& problem,
                                         const Eigen::VectorXd& start,
                                         const LeastSquaresLimits& limits) {
  LeastSquaresSolution out;
  out.parameters = start;
  Functor functor{problem, start.size(), {}, {}};
  Eigen::LevenbergMarquardt<Functor> solver(functor);
  solver.parameters.ftol = limits.cost_change;
  solver.parameters.xtol = limits.step;
  solver.parameters.maxfev = limits.evaluations;
  const auto status = solver.minimize(out.parameters);
  out.evaluations = static_cast<int>(solver.nfev);
  out.cost = solver.fnorm * solver.fnorm / 2;
  using namespace Eigen::LevenbergMarquardtSpace;
  out.converged = out.parameters.allFinite() && std::isfinite(out.cost) &&
                  (status == RelativeReductionTooSmall || status == RelativeErrorTooSmall ||
                   status == RelativeErrorAndReductionTooSmall || status == CosinusTooSmall ||
                   status == FtolTooSmall || status == XtolTooSmall || status == GtolTooSmall);
  return out;
}

}  // namespace tribolog::statistics
