#include "exports/results/certified_curve.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>

#include "base/requirements.h"

namespace tribolog::exports::results {
namespace {

/// Of a friction torque's scale, as a share of it.
struct ScaleError {
  double standard{};
  std::vector<calibration::Influence> left_out;
};

ScaleError scale_error(const ArchivedJoint& joint, const calibration::RecordedEvidence& coulomb,
                       int gear_power) {
  using calibration::Influence;
  const calibration::Quantity* const torque = joint.found(joint::Quantity::coulomb_torque);
  const double value = torque == nullptr ? 0 : present(torque->estimate).value;
  if (value == 0 || !coulomb.budget) {
    ScaleError unknown{0, {Influence::torque_constant}};
    if (gear_power != 0) unknown.left_out.push_back(Influence::gear_ratio);
    return unknown;
  }
  const calibration::UncertaintyBudget budget =
      gear_power == 0 ? *coulomb.budget
                      : calibration::budget_at(*coulomb.budget, *torque->estimate, gear_power);
  double variance = 0;
  for (const calibration::BudgetPart& part : budget.parts) {
    if (part.is_type_b) variance += part.standard_uncertainty * part.standard_uncertainty;
  }
  return {std::sqrt(variance) / std::abs(value), left_out_of(budget, gear_power)};
}

std::vector<std::size_t> by_speed(const std::vector<double>& speeds) {
  std::vector<std::size_t> order(speeds.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return speeds[a] < speeds[b]; });
  return order;
}

bool all_are_finite(const std::vector<double>& values) {
  return std::all_of(values.begin(), values.end(), [](double x) { return std::isfinite(x); });
}

}  // namespace

std::vector<calibration::Influence> left_out_of(const calibration::UncertaintyBudget& budget,
                                                int gear_power) {
  using calibration::Influence;
  std::vector<Influence> left_out = budget.not_stated;
  const bool tells_of_gear =
      std::any_of(budget.parts.begin(), budget.parts.end(),
                  [](const auto& part) { return part.influence == Influence::gear_ratio; }) ||
      std::find(left_out.begin(), left_out.end(), Influence::gear_ratio) != left_out.end();
  if (gear_power != 0 && !tells_of_gear) left_out.push_back(Influence::gear_ratio);
  return left_out;
}

CertifiedCurve certified_curve(const ArchivedJoint& joint,
                               const calibration::RecordedEvidence& coulomb, int gear_power) {
  const calibration::RecordedFriction friction =
      calibration::read_curves(joint.calibration).friction;
  CertifiedCurve curve;
  curve.from_sweep = friction.from_sweep;
  curve.holds_gravity = all_are_finite(friction.half_band_Nm);
  const std::vector<double>& recorded =
      curve.holds_gravity ? friction.half_band_Nm : friction.half_width_Nm;
  const bool is_uncertain = all_are_finite(recorded);
  const ScaleError scale = scale_error(joint, coulomb, gear_power);
  curve.left_out = scale.left_out;
  const double factor = gear_power == 0 ? 1 : joint.entry.facts.gear_ratio;
  const double k = calibration::coverage_factor(std::numeric_limits<double>::infinity());
  for (const std::size_t i : by_speed(friction.speed_rad_s)) {
    const double torque_Nm = friction.friction_Nm[i];
    curve.speed_rad_s.push_back(friction.speed_rad_s[i] / factor);
    curve.friction_Nm.push_back(factor * torque_Nm);
    if (!is_uncertain) continue;
    curve.expanded_Nm.push_back(std::abs(factor) *
                                std::hypot(recorded[i], k * scale.standard * torque_Nm));
  }
  return curve;
}

}  // namespace tribolog::exports::results
