#include "history/quantity_traits.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "history/comparison.h"
#include "history/joint_trend.h"

namespace tribolog::history {

QuantityTraits traits_of(const std::string& name) {
  static const std::array<std::pair<const char*, QuantityTraits>, 11> known{{
      {"cog_angle", {false, true, false, true}},
      {"gravity_torque", {false, true, false, false}},
      {"surrogate_mass", {false, true, false, false}},
      {"coulomb_torque", {true, false, false, false}},
      {"stribeck_speed", {true, false, false, false}},
      {"viscous_coefficient", {true, false, false, false}},
      {"viscous_curve", {true, false, false, false}},
      {"break_away_torque", {true, false, true, false}},
      {"bristle_stiffness", {false, false, true, false}},
      {"bristle_damping", {true, false, true, false}},
      {"inertia", {false, true, true, false}},
  }};
  for (const auto& [key, traits] : known) {
    if (name == key) return traits;
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
    case TrendState::recovered:
      return {"trend.recovered"};
    case TrendState::warning:
      break;
  }
  return {"trend.changed"};
}

}  // namespace tribolog::history
