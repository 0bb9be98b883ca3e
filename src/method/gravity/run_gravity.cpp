#include "method/gravity/run_gravity.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Core>

#include "joint/degrees.h"
#include "method/gravity/run_gravity_rows.h"
#include "statistics/block_regression.h"
#include "statistics/distributions.h"
#include "statistics/linear_systems.h"

namespace tribolog::method::gravity {
namespace {

constexpr double least_travel_share = 0.25;
constexpr double least_travel_rad = 3 / joint::degrees_per_rad;
constexpr std::size_t fewest_blocks = 6;
// As for the sweep: a probability far below 0.1 % without gravity.
constexpr double least_evidence = 27;
// An amplitude with a larger relative half width is no candidate for the mass.
constexpr double widest_share = 0.2;
constexpr double hardly = 0.05;  // share of a way

/// Least squares with blocks in the order of the rows; `block` gives a row's block.
template <class Block>
statistics::BlockRegression fit(std::vector<GravityRow> rows, Block block) {
  std::stable_sort(rows.begin(), rows.end(),
                   [&](const GravityRow& a, const GravityRow& b) { return block(a) < block(b); });
  const auto n = static_cast<Eigen::Index>(rows.size());
  Eigen::MatrixXd x(n, 2);
  Eigen::VectorXd y(n);
  std::vector<std::size_t> blocks;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const bool is_new = i > 0 && block(rows[i]) != block(rows[i - 1]);
    blocks.push_back(i == 0 ? 0 : blocks.back() + (is_new ? 1 : 0));
    x.row(static_cast<Eigen::Index>(i)) << rows[i].cosine, rows[i].sine;
    y(static_cast<Eigen::Index>(i)) = rows[i].torque_Nm;
  }
  return statistics::block_regression(x, y, blocks);
}

/// Rows at the same angle share the ripple, rows of a run share its day: the two-way clustered
/// variance is that of the one grouping plus that of the other less that of their intersection (A.
/// C. Cameron, J. B. Gelbach, D. L. Miller, J. Bus. Econ. Stat. 29 (2011) 238-249).
class TwoWayFit {
 public:
  explicit TwoWayFit(const std::vector<GravityRow>& rows, std::size_t runs)
      : by_angle_(fit(rows, angle_block)),
        // Too few runs do not show how runs differ.
        by_run_(runs >= fewest_blocks ? fit(rows, run_of) : by_angle_),
        by_both_(runs >= fewest_blocks ? fit(rows, angle_and_run) : by_angle_) {}

  [[nodiscard]] const statistics::BlockRegression& by_angle() const { return by_angle_; }
  [[nodiscard]] const statistics::BlockRegression& by_run() const { return by_run_; }
  /// Half width of the 95 % interval of a quantity with this gradient.
  [[nodiscard]] double half_width(const Eigen::Vector2d& gradient) const {
    const auto variance = [&](const statistics::BlockRegression& r) {
      return std::pow(r.standard_error_along(gradient), 2);
    };
    // Runs cannot reduce the variance that the blocks of the angle show.
    const double added = std::max(0.0, variance(by_run_) - variance(by_both_));
    const double freedom =
        std::min(by_angle_.freedom_along(gradient), by_run_.freedom_along(gradient));
    return statistics::student_t_975(freedom) * std::sqrt(variance(by_angle_) + added);
  }

 private:
  static std::size_t angle_block(const GravityRow& r) {
    return r.cell * GravityCells::blocks / GravityCells::count;
  }
  static std::size_t run_of(const GravityRow& r) { return r.run; }
  static std::size_t angle_and_run(const GravityRow& r) {
    return r.run * GravityCells::blocks + angle_block(r);
  }
  statistics::BlockRegression by_angle_, by_run_, by_both_;
};

bool lifts_always(const std::vector<GravityRun>& runs, double q_peak) {
  double lifted = 0;
  double all = 0;
  for (const GravityRun& run : runs) {
    const double direction = run.plateau.speed_rad_s > 0 ? 1.0 : -1.0;
    for (std::size_t i = run.plateau.first; i < run.plateau.last; ++i) {
      lifted += direction * std::cos(run.recording->q_rad[i] - q_peak) > 0 ? 1 : 0;
      all += 1;
    }
  }
  return lifted >= (1 - hardly) * all || lifted <= hardly * all;
}

}  // namespace

RunGravityResult identify_run_gravity(const std::vector<const joint::Recording*>& recordings,
                                      double gear_ratio,
                                      const std::optional<TorqueOfAngle>& of_angle) {
  RunGravityResult out;
  if (recordings.empty()) {
    out.reason = {"gravity.no_runs"};
    return out;
  }
  std::vector<GravityRun> runs = gravity_runs_of(recordings);
  const std::size_t all_runs = runs.size();
  double widest = 0;
  for (const GravityRun& run : runs) widest = std::max(widest, run.high_rad - run.low_rad);
  const double least = std::max(least_travel_rad, least_travel_share * widest);
  runs.erase(
      std::remove_if(runs.begin(), runs.end(),
                     [&](const GravityRun& run) { return run.high_rad - run.low_rad < least; }),
      runs.end());
  out.runs_used = runs.size();
  out.runs_left_out = all_runs - runs.size();
  if (runs.empty()) {
    out.reason = {"gravity.runs_too_short",
                  {{"widest_deg", widest * joint::degrees_per_rad},
                   {"needed_deg", least_travel_rad * joint::degrees_per_rad}}};
    return out;
  }
  out.lowest_rad = runs.front().low_rad;
  out.highest_rad = runs.front().high_rad;
  for (const GravityRun& run : runs) {
    out.lowest_rad = std::min(out.lowest_rad, run.low_rad);
    out.highest_rad = std::max(out.highest_rad, run.high_rad);
    out.samples_used += run.plateau.size();
  }
  const GravityCells cells{out.lowest_rad, out.highest_rad};
  const double middle = cells.middle_rad();
  const TwoWayFit with_ripple(gravity_rows(runs, cells, gear_ratio, {}, of_angle), runs.size());
  const Eigen::VectorXd& smooth = with_ripple.by_angle().coefficients;
  const Ripple ripple = ripple_of_runs(runs, cells, gear_ratio, smooth(0), smooth(1), of_angle);
  const TwoWayFit fitted(gravity_rows(runs, cells, gear_ratio, ripple, of_angle), runs.size());
  const double b = fitted.by_angle().coefficients(0);
  const double c = fitted.by_angle().coefficients(1);
  const double g = std::hypot(b, c);
  out.ripple = ripple;
  out.residual_Nm = fitted.by_angle().residual_sd;
  constexpr Code method{"interval.runs_blocks"};
  out.gravity_Nm = statistics::symmetric_estimate(
      g, fitted.half_width(Eigen::Vector2d(b, c) / std::max(g, 1e-300)), method);
  const Eigen::Vector2d angle_gradient = Eigen::Vector2d(-c, b) / std::max(g * g, 1e-300);
  double q_peak = middle + std::atan2(c, b);
  q_peak -= 2 * std::numbers::pi * std::round((q_peak - middle) / (2 * std::numbers::pi));
  out.q_peak_rad =
      statistics::symmetric_estimate(q_peak, fitted.half_width(angle_gradient), method);
  const Eigen::Vector2d bc(b, c);
  const auto evidence = [&](const statistics::BlockRegression& r) {
    return statistics::mahalanobis_square(r.covariance.topLeftCorner(2, 2), bc);
  };
  const double least_shown = std::min(evidence(fitted.by_angle()), evidence(fitted.by_run()));
  if (least_shown < least_evidence || !(out.gravity_Nm.low > 0) ||
      !(out.gravity_Nm.half_width() <= widest_share * g)) {
    out.reason = {
        "gravity.not_shown_by_runs",
        {{"gravity_Nm", g}, {"low_Nm", out.gravity_Nm.low}, {"high_Nm", out.gravity_Nm.high}}};
    return out;
  }
  out.always_lifts = lifts_always(runs, q_peak);
  out.found = true;
  return out;
}

}  // namespace tribolog::method::gravity
