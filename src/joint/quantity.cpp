#include "joint/quantity.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace tribolog::joint {
namespace {

/// In the order of the enumeration.
constexpr std::array keys{
    "cog_angle",         "gravity_torque",      "surrogate_mass", "break_away_torque",
    "bristle_stiffness", "bristle_damping",     "inertia",        "coulomb_torque",
    "stribeck_speed",    "viscous_coefficient", "viscous_curve"};

}  // namespace

std::string to_string(Quantity quantity) { return keys.at(static_cast<std::size_t>(quantity)); }

std::optional<Quantity> quantity_of(const std::string& key) {
  const auto* const at = std::find(keys.begin(), keys.end(), key);
  if (at == keys.end()) return std::nullopt;
  return static_cast<Quantity>(at - keys.begin());
}

}  // namespace tribolog::joint
