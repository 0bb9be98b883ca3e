#include "method/viscous/waiboer_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <Eigen/Core>

#include "method/motion/plateaus.h"
#include "method/viscous/viscous_curves.h"
#include "statistics/block_regression.h"
#include "statistics/levenberg_marquardt.h"

namespace tribolog::method::viscous {
namespace {

constexpr std::size_t fewest_points = 8;
constexpr int parameters = 5;

Eigen::VectorXd first_guess(const std::vector<CurvePoint>& points, double stribeck_speed,
                            double stribeck_power) {
  const double slow = std::max(points.front().friction_Nm, 1e-9);
  const double fast = std::max(points.back().friction_Nm, 1e-9);
  const double exponent = 0.6;
  Eigen::VectorXd p(parameters);
  p << std::log(slow), std::log(stribeck_speed), std::log(stribeck_power),
      std::log(fast / std::pow(points.back().speed_rad_s, exponent)), std::log(exponent);
  return p;
}

}  // namespace

void waiboer_residuals(const std::vector<CurvePoint>& points, const Eigen::VectorXd& p,
                       Eigen::VectorXd& r, Eigen::MatrixXd* j) {
  const double ta = std::exp(p(0));
  const double ws = std::exp(p(1));
  const double da = std::exp(p(2));
  const double cv = std::exp(p(3));
  const double exponent = std::exp(p(4));
  r.resize(static_cast<Eigen::Index>(points.size()));
  if (j != nullptr) j->resize(r.size(), parameters);
  for (Eigen::Index i = 0; i < r.size(); ++i) {
    const CurvePoint& point = points[static_cast<std::size_t>(i)];
    const double w = std::max(point.speed_rad_s, 1e-12);
    const double power = std::pow(w / ws, da);
    const double asperity = ta * std::exp(-power);
    const double viscous = cv * std::pow(w, exponent);
    r(i) = asperity + viscous - point.friction_Nm;
    if (j != nullptr) {
      j->row(i) << asperity, asperity * power * da, -asperity * power * da * std::log(w / ws),
          viscous, viscous * exponent * std::log(w);
    }
  }
}

std::optional<WaiboerFit> fit_waiboer(const std::vector<CurvePoint>& points, Statement& why_not) {
  if (points.size() < fewest_points) {
    why_not = {"waiboer_fit.too_few_runs", {{"runs", points.size()}, {"needed", fewest_points}}};
    return std::nullopt;
  }
  const statistics::LeastSquaresProblem problem{
      static_cast<Eigen::Index>(points.size()),
      [&](const Eigen::VectorXd& p, Eigen::VectorXd& r, Eigen::MatrixXd* j) {
        waiboer_residuals(points, p, r, j);
      }};
  statistics::LeastSquaresSolution best;
  best.cost = std::numeric_limits<double>::infinity();
  const double slowest = std::max(points.front().speed_rad_s, 1e-6);
  for (const double share : {0.15, 0.3, 0.5, 0.7}) {
    const double ws = slowest * std::pow(points.back().speed_rad_s / slowest, share);
    for (const double power : {0.5, 1.0, 2.0}) {
      const statistics::LeastSquaresSolution s =
          statistics::solve_least_squares(problem, first_guess(points, ws, power));
      if (s.converged && s.cost < best.cost) best = s;
    }
  }
  if (!best.converged) {
    why_not = {"waiboer_fit.did_not_converge"};
    return std::nullopt;
  }
  Eigen::VectorXd r;
  Eigen::MatrixXd j;
  waiboer_residuals(points, best.parameters, r, &j);
  // Runs of one speed are no independent witnesses of it: what is left over them is the same.
  std::vector<std::size_t> blocks(points.size(), 0);
  double first_rad_s = points.front().speed_rad_s;
  for (std::size_t i = 1; i < blocks.size(); ++i) {
    const bool is_new = points[i].speed_rad_s > (1 + motion::same_speed) * first_rad_s;
    if (is_new) first_rad_s = points[i].speed_rad_s;
    blocks[i] = blocks[i - 1] + (is_new ? 1 : 0);
  }
  const statistics::BlockRegression around = statistics::block_regression(j, -r, blocks);
  const auto positive = [&](int k) {
    const double h = around.half_width(k);
    const double value = best.parameters(k);
    return statistics::Estimate{
        std::exp(value), std::exp(value - h), std::exp(value + h), {"interval.curve_fit"}};
  };
  WaiboerFit fit;
  fit.converged = true;
  fit.asperity_torque_Nm = positive(0);
  fit.stribeck_speed_rad_s = positive(1);
  fit.stribeck_power = positive(2);
  fit.viscous_coefficient = positive(3);
  const statistics::Estimate exponent = positive(4);
  fit.viscous_power = {1 - exponent.value, 1 - exponent.high, 1 - exponent.low, exponent.method};
  fit.residual_Nm =
      std::sqrt(r.squaredNorm() / std::max(1.0, static_cast<double>(r.size()) - parameters));
  // An infinite interval means that the curve does not show the parameter at all.
  for (const statistics::Estimate* e :
       {&fit.asperity_torque_Nm, &fit.stribeck_speed_rad_s, &fit.stribeck_power,
        &fit.viscous_coefficient, &fit.viscous_power}) {
    if (!std::isfinite(e->low) || !std::isfinite(e->high)) {
      why_not = {"waiboer_fit.parameters_not_shown"};
      return std::nullopt;
    }
  }
  if (fit.viscous_power.value < 0) {
    why_not = {"waiboer_fit.grows_faster_than_speed"};
    return std::nullopt;
  }
  return fit;
}

std::optional<friction::WaiboerFriction> waiboer_of(const std::optional<WaiboerFit>& fit) {
  if (!fit || !fit->converged) return std::nullopt;
  constexpr double step_at_rest_s_rad = 1e6;
  const std::array parameters{&fit->asperity_torque_Nm, &fit->stribeck_speed_rad_s,
                              &fit->stribeck_power, &fit->viscous_coefficient, &fit->viscous_power};
  if (std::any_of(parameters.begin(), parameters.end(), [](const statistics::Estimate* p) {
        return !std::isfinite(p->value) || !(p->value > 0);
      })) {
    return std::nullopt;  // a calibration file may hold anything
  }
  return friction::WaiboerFriction({fit->asperity_torque_Nm.value, fit->stribeck_speed_rad_s.value,
                                    fit->stribeck_power.value, fit->viscous_coefficient.value,
                                    fit->viscous_power.value, step_at_rest_s_rad});
}

}  // namespace tribolog::method::viscous
