#include "history/quantity_traits.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

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

}  // namespace tribolog::history
