#include "method/selection/quality_errors.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "base/enum_text.h"
#include "friction/friction_model.h"

namespace tribolog::method::selection {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
// A driving torque below this share of the largest makes a percentage of it meaningless.
constexpr double smallest_torque_share = 0.05;
// With a reference for a smaller share of the runs, an error would represent only a few of them.
constexpr double least_share_with_reference = 0.2;

Statement no_reference(const viscous::ViscousCurvesResult& curves, std::size_t with_reference) {
  if (with_reference == 0) {
    return {"quality_errors.no_pairs",
            {{"runs", curves.runs.size()}, {"angles", curves.angles.described()}}};
  }
  return {"quality_errors.too_few_pairs",
          {{"paired", with_reference},
           {"runs", curves.runs.size()},
           {"angles", curves.angles.described()}}};
}

Statement evidence_of(const QualityErrorsResult& q) {
  if (q.reference == CurveReference::analytic) return {"quality_errors.reference_exact"};
  if (std::isnan(q.reference_rms_percent)) return {};
  std::vector<Statement> within;
  for (const QualityError& e : q.errors) {
    if (e.rms_percent > q.reference_rms_percent) continue;
    within.push_back({"quality_errors.estimator", {{"estimator", to_string(e.estimator)}}});
  }
  if (within.empty()) {
    return {"quality_errors.all_beyond_reference",
            {{"reference_percent", q.reference_rms_percent}}};
  }
  return {"quality_errors.some_within_reference",
          {{"reference_percent", q.reference_rms_percent}, {"estimators", within}}};
}

/// Over the runs whose reference has an interval: a speed that was driven once in each direction
/// may have none.
template <class Usable>
double reference_rms_percent(const std::vector<viscous::ConstantSpeedRun>& runs,
                             const std::vector<double>& half_width_Nm, Usable usable) {
  double squares = 0;
  std::size_t known = 0;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const double percent = 100 * half_width_Nm[i] / runs[i].torque_Nm;
    if (!usable(i) || !std::isfinite(percent)) continue;
    squares += percent * percent;
    ++known;
  }
  return known > 0 ? std::sqrt(squares / static_cast<double>(known)) : std::nan("");
}

}  // namespace

std::string to_string(CurveReference reference) {
  return reference == CurveReference::none ? "" : own_name(reference);
}

const QualityError* QualityErrorsResult::find(
    std::optional<hysteresis::Estimator> estimator) const {
  const auto it = std::find_if(errors.begin(), errors.end(),
                               [&](const QualityError& e) { return e.estimator == estimator; });
  return it == errors.end() ? nullptr : &*it;
}

QualityErrorsResult identify_quality_errors(const viscous::ViscousCurvesResult& curves,
                                            const friction::StaticFriction* analytic) {
  QualityErrorsResult out;
  out.stage = {"quality_errors", statistics::StageState::skipped, {}};
  if (curves.runs.empty() || curves.curves.empty()) {
    out.stage.reason =
        curves.stage.reason.empty() ? Statement{"quality_errors.no_curve"} : curves.stage.reason;
    return out;
  }
  std::size_t with_reference = 0;
  double largest = 0;
  for (const viscous::ConstantSpeedRun& run : curves.runs) {
    const double reference =
        analytic != nullptr ? analytic->torque_Nm(run.speed_rad_s) : run.direction_difference_Nm;
    out.reference_Nm.push_back(reference);
    out.reference_half_width_Nm.push_back(
        analytic != nullptr ? 0.0 : run.direction_difference_half_width_Nm);
    with_reference += std::isfinite(reference) ? 1 : 0;
    largest = std::max(largest, std::abs(run.torque_Nm));
  }
  if (static_cast<double>(with_reference) <
      std::max(1.0, least_share_with_reference * static_cast<double>(curves.runs.size()))) {
    out.stage.state = statistics::StageState::not_identifiable;
    out.stage.reason = no_reference(curves, with_reference);
    return out;
  }
  out.reference =
      analytic != nullptr ? CurveReference::analytic : CurveReference::direction_difference;
  const auto usable = [&](std::size_t i) {
    return std::isfinite(out.reference_Nm[i]) &&
           std::abs(curves.runs[i].torque_Nm) > smallest_torque_share * largest;
  };
  std::size_t used = 0;
  for (std::size_t i = 0; i < curves.runs.size(); ++i) used += usable(i) ? 1 : 0;
  out.runs_left_out = curves.runs.size() - used;
  out.reference_rms_percent =
      reference_rms_percent(curves.runs, out.reference_half_width_Nm, usable);
  for (const viscous::ViscousCurve& curve : curves.curves) {
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
  out.evidence = evidence_of(out);
  out.stage.state = statistics::StageState::done;
  if (out.runs_left_out > 0) {
    out.stage.state = statistics::StageState::partial;
    out.stage.reason = {"quality_errors.runs_left_out",
                        {{"left_out", out.runs_left_out},
                         {"runs", curves.runs.size()},
                         {"least_percent", 100 * smallest_torque_share}}};
  }
  return out;
}

}  // namespace tribolog::method::selection
