#include "stages/quality_errors.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace tribolog {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
// A driving torque below this share of the largest makes a percentage of it meaningless.
constexpr double smallest_torque_share = 0.05;

}  // namespace

const QualityError* QualityErrorsResult::find(const std::string& estimator) const {
  const auto it = std::find_if(errors.begin(), errors.end(),
                               [&](const QualityError& e) { return e.estimator == estimator; });
  return it == errors.end() ? nullptr : &*it;
}

QualityErrorsResult identify_quality_errors(const ViscousCurvesResult& curves,
                                            const StaticFriction* analytic) {
  QualityErrorsResult out;
  out.stage = {"quality_errors", StageState::skipped, ""};
  if (curves.runs.empty() || curves.curves.empty()) {
    out.stage.reason = "there is no viscous curve to judge";
    return out;
  }
  bool any = false;
  double largest = 0;
  for (const ConstantSpeedRun& run : curves.runs) {
    const double reference =
        analytic != nullptr ? analytic->torque_Nm(run.speed_rad_s) : run.direction_difference_Nm;
    out.reference_Nm.push_back(reference);
    any = any || std::isfinite(reference);
    largest = std::max(largest, std::abs(run.torque_Nm));
  }
  if (!any) {
    out.stage.state = StageState::not_identifiable;
    out.stage.reason =
        "no reference: no run has a partner of opposite direction at the same speed over common "
        "angles, and no true curve is known; recording both directions over the same angles would "
        "give one";
    return out;
  }
  out.reference = analytic != nullptr ? "analytic" : "direction_difference";
  const auto usable = [&](std::size_t i) {
    return std::isfinite(out.reference_Nm[i]) &&
           std::abs(curves.runs[i].torque_Nm) > smallest_torque_share * largest;
  };
  std::size_t used = 0;
  for (std::size_t i = 0; i < curves.runs.size(); ++i) used += usable(i) ? 1 : 0;
  out.runs_left_out = curves.runs.size() - used;
  for (const ViscousCurve& curve : curves.curves) {
    QualityError error{curve.estimator, {}, 0.0};
    double squares = 0;
    for (std::size_t i = 0; i < curves.runs.size(); ++i) {
      const double percent =
          usable(i) ? 100 * (curve.friction_Nm[i] - out.reference_Nm[i]) / curves.runs[i].torque_Nm
                    : nan;
      error.percent.push_back(percent);
      if (usable(i)) squares += percent * percent;
    }
    error.rms_percent = used > 0 ? std::sqrt(squares / static_cast<double>(used)) : nan;
    out.errors.push_back(std::move(error));
  }
  out.stage.state = StageState::done;
  if (out.runs_left_out > 0) {
    out.stage.state = StageState::partial;
    out.stage.reason = fmt::format(
        "{} of {} runs take no part: without a partner of opposite direction, or with a driving "
        "torque below {:.0f} % of the largest",
        out.runs_left_out, curves.runs.size(), 100 * smallest_torque_share);
  }
  return out;
}

}  // namespace tribolog
