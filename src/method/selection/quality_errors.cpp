#include "method/selection/quality_errors.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace tribolog::method::selection {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
// A driving torque below this share of the largest makes a percentage of it meaningless.
constexpr double smallest_torque_share = 0.05;
// With a reference for less than this share of the runs, an error would speak of a few stray ones.
constexpr double least_share_with_reference = 0.2;

std::string no_reference(const viscous::ViscousCurvesResult& curves, std::size_t with_reference) {
  return fmt::format(
      "no reference: {} of {} runs have a partner of opposite direction at the same speed over "
      "common angles ({}), and no true curve is known; half the difference of the directions "
      "cannot serve; recording every speed in both directions over the same angles would give it",
      with_reference == 0 ? std::string("none") : std::to_string(with_reference),
      curves.runs.size(), curves.angles.in_words());
}

std::string evidence_in_words(const QualityErrorsResult& q) {
  if (q.reference == "analytic") return "the reference is known exactly";
  std::string within;
  for (const QualityError& e : q.errors) {
    if (e.rms_percent > q.reference_rms_percent) continue;
    within += (within.empty() ? "" : ", ") + e.estimator;
  }
  return fmt::format(
      "the reference itself is known to {:.2g} % of the driving torque (rms, 95 %): {}",
      q.reference_rms_percent,
      within.empty() ? "all errors are larger and count as evidence"
                     : "an error below that is no evidence, as those of " + within + " are");
}

}  // namespace

const QualityError* QualityErrorsResult::find(const std::string& estimator) const {
  const auto it = std::find_if(errors.begin(), errors.end(),
                               [&](const QualityError& e) { return e.estimator == estimator; });
  return it == errors.end() ? nullptr : &*it;
}

QualityErrorsResult identify_quality_errors(const viscous::ViscousCurvesResult& curves,
                                            const friction::StaticFriction* analytic) {
  QualityErrorsResult out;
  out.stage = {"quality_errors", statistics::StageState::skipped, ""};
  if (curves.runs.empty() || curves.curves.empty()) {
    out.stage.reason = "there is no viscous curve to judge";
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
  out.reference = analytic != nullptr ? "analytic" : "direction_difference";
  const auto usable = [&](std::size_t i) {
    return std::isfinite(out.reference_Nm[i]) &&
           std::abs(curves.runs[i].torque_Nm) > smallest_torque_share * largest;
  };
  std::size_t used = 0;
  for (std::size_t i = 0; i < curves.runs.size(); ++i) used += usable(i) ? 1 : 0;
  out.runs_left_out = curves.runs.size() - used;
  double reference_squares = 0;
  for (std::size_t i = 0; i < curves.runs.size(); ++i) {
    if (!usable(i)) continue;
    const double percent = 100 * out.reference_half_width_Nm[i] / curves.runs[i].torque_Nm;
    reference_squares += percent * percent / static_cast<double>(used);
  }
  out.reference_rms_percent = std::sqrt(reference_squares);
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
  out.evidence = evidence_in_words(out);
  out.stage.state = statistics::StageState::done;
  if (out.runs_left_out > 0) {
    out.stage.state = statistics::StageState::partial;
    out.stage.reason = fmt::format(
        "{} of {} runs take no part: without a partner of opposite direction, or with a driving "
        "torque below {:.0f} % of the largest",
        out.runs_left_out, curves.runs.size(), 100 * smallest_torque_share);
  }
  return out;
}

}  // namespace tribolog::method::selection
