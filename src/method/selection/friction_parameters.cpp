#include "method/selection/friction_parameters.h"

#include <algorithm>
#include <cmath>

#include "method/viscous/waiboer_fit.h"
#include "statistics/block_regression.h"

namespace tribolog::method::selection {
namespace {

constexpr std::size_t fewest_speeds_for_a_line = 4;

/// |Tf| against |w|, both directions together, sorted by speed.
std::vector<viscous::CurvePoint> magnitudes(const viscous::ViscousCurvesResult& curves,
                                            const viscous::ViscousCurve& curve) {
  std::vector<viscous::CurvePoint> points;
  for (std::size_t i = 0; i < curves.runs.size(); ++i) {
    const double sign = curves.runs[i].speed_rad_s < 0 ? -1.0 : 1.0;
    points.push_back({std::abs(curves.runs[i].speed_rad_s), sign * curve.friction_Nm[i]});
  }
  std::sort(points.begin(), points.end(),
            [](const viscous::CurvePoint& a, const viscous::CurvePoint& b) {
              return a.speed_rad_s < b.speed_rad_s;
            });
  return points;
}

/// A straight line over the points from `first` on.
CoulombViscousFit fit_line(const std::vector<viscous::CurvePoint>& points, std::size_t first) {
  const auto n = static_cast<Eigen::Index>(points.size() - first);
  Eigen::MatrixXd x(n, 2);
  Eigen::VectorXd y(n);
  std::vector<std::size_t> blocks(static_cast<std::size_t>(n));
  for (Eigen::Index i = 0; i < n; ++i) {
    const viscous::CurvePoint& p = points[first + static_cast<std::size_t>(i)];
    x.row(i) << 1, p.speed_rad_s;
    y(i) = p.friction_Nm;
    blocks[static_cast<std::size_t>(i)] = static_cast<std::size_t>(i);
  }
  const statistics::BlockRegression fit = statistics::block_regression(x, y, blocks);
  const auto half_width = [&](int k) { return fit.half_width(k); };
  return {
      statistics::symmetric_estimate(fit.coefficients(0), half_width(0), {"interval.line_runs"}),
      statistics::symmetric_estimate(fit.coefficients(1), half_width(1), {"interval.line_runs"}),
      fit.residual_sd, points[first].speed_rad_s, points.back().speed_rad_s};
}

}  // namespace

FrictionParametersResult fit_friction_parameters(const viscous::ViscousCurvesResult& curves,
                                                 const SelectionResult& selection) {
  FrictionParametersResult out;
  out.stage = {"friction_parameters", statistics::StageState::skipped, {}};
  const viscous::ViscousCurve* curve = curves.find(selection.recommended);
  if (curve == nullptr || curves.runs.empty()) {
    const bool has_no_runs = curves.runs.empty() && !curves.stage.reason.empty();
    out.stage.reason =
        has_no_runs ? curves.stage.reason : Statement{"friction_parameters.no_curve"};
    return out;
  }
  out.curve = curve->estimator;
  const std::vector<viscous::CurvePoint> points = magnitudes(curves, *curve);
  // The line leaves out the Stribeck dip: it starts at the speed of least friction.
  const auto dip = std::min_element(points.begin(), points.end(),
                                    [](const viscous::CurvePoint& a, const viscous::CurvePoint& b) {
                                      return a.friction_Nm < b.friction_Nm;
                                    });
  auto first = static_cast<std::size_t>(dip - points.begin());
  if (first > points.size() / 2) first = 0;  // friction that falls all along has no dip
  if (points.size() - first < fewest_speeds_for_a_line) {
    out.stage.state = statistics::StageState::not_identifiable;
    out.stage.reason = {"friction_parameters.too_few_runs",
                        {{"runs", points.size() - first}, {"needed", fewest_speeds_for_a_line}}};
    return out;
  }
  out.coulomb_viscous = fit_line(points, curves.from_sweep ? 0 : first);
  Statement why_not;
  // In a paired sweep angle and speed change together: five parameters would fit the angle.
  if (curves.from_sweep) {
    why_not = {"friction_parameters.speed_changes_with_angle"};
  } else {
    out.waiboer = viscous::fit_waiboer(points, why_not);
  }
  out.stage.state = out.waiboer ? statistics::StageState::done : statistics::StageState::partial;
  if (!out.waiboer) {
    out.stage.reason = {"friction_parameters.waiboer_not_fitted", {{"why", why_not}}};
  }
  return out;
}

FrictionCurve fitted_curve(const FrictionParametersResult& fitted) {
  if (!fitted.coulomb_viscous) return {};
  const CoulombViscousFit& line = *fitted.coulomb_viscous;
  FrictionCurve curve;
  constexpr int points = 200;
  for (int i = 0; i <= points; ++i) {
    // Denser at low speed, where the Stribeck effect bends the curve.
    const double share = static_cast<double>(i) / points;
    const double w = line.fastest_rad_s * share * share;
    curve.speed_rad_s.push_back(w);
    curve.torque_Nm.push_back(fitted.waiboer
                                  ? viscous::waiboer_of(*fitted.waiboer).magnitude_Nm(w)
                                  : line.coulomb_Nm.value + line.viscous_Nms_rad.value * w);
  }
  return curve;
}

}  // namespace tribolog::method::selection
