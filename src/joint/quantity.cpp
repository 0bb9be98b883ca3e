#include "joint/quantity.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>
#include <utility>

namespace tribolog::joint {
namespace {

/// In the order of the enumeration.
constexpr std::array keys{
    "cog_angle",         "gravity_torque",      "surrogate_mass", "break_away_torque",
    "bristle_stiffness", "bristle_damping",     "inertia",        "coulomb_torque",
    "stribeck_speed",    "viscous_coefficient", "viscous_curve"};

/// In the order of the enumeration.
constexpr std::array units{"rad",   "N·m", "kg",    "N·m",       "N·m/rad", "N·m·s/rad",
                           "kg·m²", "N·m", "rad/s", "N·m·s/rad", ""};

}  // namespace

std::string to_string(Quantity quantity) { return keys.at(static_cast<std::size_t>(quantity)); }

std::optional<Quantity> quantity_of(const std::string& key) {
  const auto* const at = std::find(keys.begin(), keys.end(), key);
  if (at == keys.end()) return std::nullopt;
  return static_cast<Quantity>(at - keys.begin());
}

std::string unit_of(Quantity quantity, TorqueUnit torque) {
  const std::string unit = units.at(static_cast<std::size_t>(quantity));
  return torque == TorqueUnit::ampere ? in_amperes(unit) : unit;
}

std::string in_amperes(std::string text) {
  using Units = std::pair<std::string_view, std::string_view>;
  constexpr std::string_view per_ampere = "/A";
  for (const auto& [torque, current] : {Units{"N·m", "A"}, Units{"kg·m²", "A·s²/rad"}}) {
    for (std::size_t at = text.find(torque); at != std::string::npos; at = text.find(torque, at)) {
      const bool is_constant =
          std::string_view(text).substr(at + torque.size()).starts_with(per_ampere);
      if (!is_constant) text.replace(at, torque.size(), current);
      at += is_constant ? torque.size() : current.size();
    }
  }
  return text;
}

}  // namespace tribolog::joint
