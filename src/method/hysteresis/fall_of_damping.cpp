#include "method/hysteresis/fall_of_damping.h"

#include <cmath>
#include <numbers>

#include "statistics/block_regression.h"
#include "statistics/linear_systems.h"

namespace tribolog::method::hysteresis {
namespace {

/// Motor speed at each row of all recordings.
Eigen::VectorXd speeds_of(const LuGreProblem& problem) {
  Eigen::VectorXd speeds(problem.rows());
  Eigen::Index top = 0;
  for (const LuGreLoopModel& model : problem.models()) {
    speeds.segment(top, model.rows()) = model.row_speeds_rad_s();
    top += model.rows();
  }
  return speeds;
}

/// All columns but one.
Eigen::MatrixXd without(const Eigen::MatrixXd& columns, Eigen::Index one) {
  Eigen::MatrixXd rest(columns.rows(), columns.cols() - 1);
  rest.leftCols(one) = columns.leftCols(one);
  rest.rightCols(columns.cols() - one - 1) = columns.rightCols(columns.cols() - one - 1);
  return rest;
}

}  // namespace

std::optional<FallOfDamping> fall_of_damping(
    const LuGreClimb& climb, const LuGreProblem& problem, const Eigen::VectorXd& contact_Nm,
    const std::optional<statistics::Estimate>& inertia_kgm2) {
  // Inertia is the last of the shared columns: without it, these two stay where they are.
  const Eigen::Index stiffness = climb.column(LuGreShared::log_stiffness);
  const Eigen::Index damping = climb.column(LuGreShared::damping);
  const Eigen::Index inertia = climb.column(LuGreShared::inertia);
  if (!climb.converged || stiffness < 0 || damping < 0) return std::nullopt;
  const statistics::LinearisedFit& fit = climb.linear.fit;
  Eigen::VectorXd left = contact_Nm - fit.residuals;
  Eigen::MatrixXd columns = fit.jacobian;
  if (inertia > damping && inertia_kgm2) {
    left -= columns.col(inertia) * (inertia_kgm2->value - climb.point.shared(LuGreShared::inertia));
    columns = without(columns, inertia);
  }
  const Eigen::VectorXd speeds = speeds_of(problem);
  const double peak = speeds.cwiseAbs().maxCoeff();
  const Eigen::Index fall = columns.cols();
  columns.conservativeResize(Eigen::NoChange, fall + 1);
  const double without_fall = statistics::least_squares(columns.leftCols(fall), left)(stiffness);
  constexpr double least_certainty = 2;
  double best = least_certainty;
  std::optional<FallOfDamping> found;
  for (const double share_of_peak : {0.15, 0.4, 1.0}) {
    const double falls_at = share_of_peak * peak;
    columns.col(fall) =
        columns.col(damping).array() * ((-(speeds / falls_at).array().square()).exp() - 1);
    const statistics::BlockRegression step =
        statistics::block_regression(columns, left, fit.block_of_row);
    const double lost = step.coefficients(fall);  // of the damping at rest
    const double certainty = lost / step.half_width(fall);
    const double effect_Nm =
        std::abs(lost) * columns.col(fall).norm() / std::sqrt(static_cast<double>(columns.rows()));
    if (!(certainty > best) || effect_Nm < smallest_effect * climb.height_Nm) continue;
    best = certainty;
    found = FallOfDamping{falls_at * std::sqrt(std::numbers::ln2),
                          step.coefficients(stiffness) - without_fall};
  }
  return found;
}

}  // namespace tribolog::method::hysteresis
