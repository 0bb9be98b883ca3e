#pragma once
// What is identified of a joint, and judged: the quantities of the verdict.

#include <optional>
#include <string>

namespace tribolog::joint {

enum class Quantity {
  cog_angle,  ///< Of the centre of gravity: where gravity's torque is largest.
  gravity_torque,
  surrogate_mass,
  break_away_torque,
  bristle_stiffness,
  bristle_damping,
  inertia,
  coulomb_torque,
  stribeck_speed,
  viscous_coefficient,
  viscous_curve,  ///< Friction over speed; it has no one number.
};

/// Stable, in files and in message codes: "coulomb_torque".
std::string to_string(Quantity quantity);

/// Of a key as to_string() gives it; nothing for any other: a file may be of another version.
std::optional<Quantity> quantity_of(const std::string& key);

}  // namespace tribolog::joint
