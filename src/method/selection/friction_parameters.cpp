#include "method/selection/friction_parameters.h"

#include <algorithm>
#include <cmath>

#include "method/viscous/waiboer_fit.h"

namespace tribolog::method::selection {
namespace {

constexpr std::size_t fewest_runs = 4;

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
  if (points.size() < fewest_runs) {
    out.stage.state = statistics::StageState::not_identifiable;
    out.stage.reason = {"friction_parameters.too_few_runs",
                        {{"runs", points.size()}, {"needed", fewest_runs}}};
    return out;
  }
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

}  // namespace tribolog::method::selection
