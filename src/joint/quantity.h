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

/// What torques are numbers of: amperes where the torque constant is not known.
enum class TorqueUnit { newton_metre, ampere };

/// SI: "N·m/rad", or "A/rad"; empty for a curve.
std::string unit_of(Quantity quantity, TorqueUnit torque);

/// Units of torques in the text as those of currents: "kN·m·s/rad" is "kA·s/rad", "kg·m²" is
/// "A·s²/rad". That of a torque constant, "N·m/A", stays.
std::string in_amperes(std::string text);

}  // namespace tribolog::joint
