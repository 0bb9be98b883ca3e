#pragma once
// Which archived numbers may go into a simulator's model, and friction for the many targets that
// know nothing but dry friction and a viscous coefficient.

#include <optional>
#include <string>
#include <vector>

#include "exports/results/archived_joint.h"

namespace tribolog::exports::results {

/// Why the quantity may not be used; empty: it may.
/// @param is_number false: the viscous curve, of which the verdict alone counts.
std::string objection(const ArchivedJoint& joint, joint::Quantity quantity, bool doubtful_too,
                      bool is_number = true);

/// What the format can do without. @return nullptr: it may not be used. @param why_not receives
/// why.
const calibration::Quantity* if_usable(const ArchivedJoint& joint, joint::Quantity quantity,
                                       bool doubtful_too, std::string& why_not);

/// "aaaaaaaaaa: not exported: " and the reason. @throw UsageError always.
[[noreturn]] void refuse_export(const ArchivedJoint& joint, const std::string& why);

/// @throw UsageError: a simulator would take the numbers of amperes for those of N·m.
void refuse_amperes(const ArchivedJoint& joint);

/// Friction torque at a speed, both at the joint, the mean of both directions.
struct SpeedFriction {
  double speed_rad_s{};
  double torque_Nm{};
  double low_Nm{};  ///< 95 % interval.
  double high_Nm{};
};

/// Those at which the verdict allows the options to use it, within the options' range; rising.
/// @param why_not receives why there are none.
std::vector<SpeedFriction> usable_friction(const ArchivedJoint& joint,
                                           const SimulatorOptions& options, std::string& why_not);

/// The same for a format that is nothing without them.
/// @throw UsageError: there are none, or torques are in amperes.
std::vector<SpeedFriction> needed_friction(const ArchivedJoint& joint,
                                           const SimulatorOptions& options);

/// As many as a table for a program needs, evenly spaced in the logarithm of the speed.
std::vector<SpeedFriction> a_few(const std::vector<SpeedFriction>& friction);

/// "0.1, 0.2"
std::string joined(const std::vector<SpeedFriction>& friction, double SpeedFriction::* member,
                   std::string (*text_of)(double));

/// dry + viscous * speed
struct FrictionLine {
  double dry_Nm{};
  double viscous_Nms_rad{};
  [[nodiscard]] double torque_Nm(double speed_rad_s) const {
    return dry_Nm + viscous_Nms_rad * speed_rad_s;
  }
};

/// The line without negative numbers whose largest error at these speeds is the smallest.
/// @param friction not empty; speeds > 0.
FrictionLine nearest_line(const std::vector<SpeedFriction>& friction);

/// Friction as most simulators take it, at the joint.
struct DryAndViscous : FrictionLine {
  double static_Nm{};  ///< At rest: break-away torque or, not known, the largest below it; >= dry.
  std::string static_words;  ///< Which of the two it is.
  bool is_approximation{};   ///< Else Coulomb torque and viscous coefficient as identified.
  /// Where the numbers are from, how far from the friction at the measured speeds, and over which.
  std::vector<std::string> comments;
};

/// Coulomb torque and viscous coefficient where both are usable and no range is stated; else the
/// line nearest to the friction at the usable speeds, marked as an approximation.
/// @param dry, viscous what the format calls the two.
/// @throw UsageError: in amperes, or neither can be used.
DryAndViscous dry_and_viscous(const ArchivedJoint& joint, const SimulatorOptions& options,
                              const std::string& dry, const std::string& viscous);

/// solimpfriction of MJCF: MuJoCo's dry friction is soft, and with the engine's usual impedance of
/// 0.9 less than frictionloss at slow speeds, by up to all of it. With this, the largest that the
/// engine takes, it is frictionloss (tests/exports/mujoco_friction.py).
inline constexpr const char* mjcf_hard_friction = "0.9999 0.9999 0.001 0.5 2";
inline constexpr const char* mjcf_hard_friction_words =
    "solimpfriction keeps MuJoCo from softening the dry friction: by itself the engine gives less "
    "than frictionloss at slow speeds.";

/// Steady sliding of the LuGre model: coulomb + (static - coulomb) exp(-(speed / stribeck)²) +
/// viscous * speed.
struct SteadyLuGre {
  double coulomb_Nm{};
  double static_Nm{};  ///< >= coulomb_Nm
  double stribeck_rad_s{};
  double viscous_Nms_rad{};
  [[nodiscard]] double torque_Nm(double speed_rad_s) const;
};

/// Of those with this torque at rest the one whose largest error at these speeds, in percent of the
/// friction there, is about the smallest; no number is below zero.
/// @param friction not empty; speeds and torques > 0. @param static_Nm > 0
SteadyLuGre nearest_lugre(const std::vector<SpeedFriction>& friction, double static_Nm);

/// "0.0123 N·m (1.2 %), at 3 rad/s": where a law is farthest from the friction.
std::string largest_error_words(const SteadyLuGre& law, const std::vector<SpeedFriction>& friction);

/// "from 0.1 to 3 rad/s"
std::string speeds_in_words(const std::vector<SpeedFriction>& friction);

/// Torque at rest: the break-away torque where it is usable, else friction at the slowest speed.
struct RestTorque {
  double torque_Nm{};
  std::string words;
};

/// At the joint. @param friction may be empty: nothing but the break-away torque is known then.
RestTorque rest_torque(const ArchivedJoint& joint, const SimulatorOptions& options,
                       const std::vector<SpeedFriction>& friction);

/// The rotor's inertia as the joint feels it: what was identified of rotor, gear and arm together
/// less the arm's, as the options state it.
struct Armature {
  std::optional<double> kgm2;  ///< Absent: left out.
  std::string words;           ///< What it is, or why it is left out.
};

Armature armature_of(const ArchivedJoint& joint, const SimulatorOptions& options);

/// As shortest(), with a point where it would read as an integer.
std::string with_point(double number);

}  // namespace tribolog::exports::results
