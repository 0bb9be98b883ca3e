#include "history/quantity_traits.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "calibration/friction_speeds.h"
#include "history/comparison.h"
#include "history/joint_trend.h"
#include "joint/quantity.h"

namespace tribolog::history {

QuantityTraits traits_of(const std::string& name) {
  using joint::Quantity;
  const std::optional<Quantity> known = joint::quantity_of(name);
  if (calibration::speed_of_friction(name)) return {true, false, false, false};
  if (!known) return {};
  switch (*known) {
    case Quantity::cog_angle:
      return {false, true, false, true};
    case Quantity::gravity_torque:
    case Quantity::surrogate_mass:
      return {false, true, false, false};
    case Quantity::coulomb_torque:
    case Quantity::stribeck_speed:
    case Quantity::viscous_coefficient:
    case Quantity::viscous_curve:
      return {true, false, false, false};
    case Quantity::break_away_torque:
    case Quantity::bristle_damping:
      return {true, false, true, false};
    case Quantity::bristle_stiffness:
      return {false, false, true, false};
    case Quantity::inertia:
      return {false, true, true, false};
  }
  return {};
}

namespace {

bool alike(double a, double b) {
  constexpr double rounding = 1e-9;
  return std::abs(a - b) <= rounding * std::max(std::abs(a), std::abs(b));
}

bool alike(const std::optional<double>& a, const std::optional<double>& b) {
  return a.has_value() == b.has_value() && (!a || alike(*a, *b));
}

}  // namespace

bool has_same_gear(const calibration::Facts& a, const calibration::Facts& b) {
  return alike(a.gear_ratio, b.gear_ratio);
}

bool has_same_payload(const calibration::Facts& a, const calibration::Facts& b) {
  return a.payload == b.payload && alike(a.payload_kg, b.payload_kg) &&
         alike(a.payload_distance_m, b.payload_distance_m);
}

// What the history's states are called.

Statement statement_of(ChangeWord word) {
  switch (word) {
    case ChangeWord::no_change_seen:
      return {"comparison.no_change_seen"};
    case ChangeWord::changed:
      return {"comparison.changed"};
    case ChangeWord::not_comparable:
      break;
  }
  return {"comparison.not_comparable"};
}

Statement statement_of(TrendState state) {
  switch (state) {
    case TrendState::too_few:
      return {"trend.too_few"};
    case TrendState::steady:
      return {"trend.steady"};
    case TrendState::apart:
      return {"trend.apart"};
    case TrendState::recovered:
      return {"trend.recovered"};
    case TrendState::warning:
      break;
  }
  return {"trend.changed"};
}

}  // namespace tribolog::history
