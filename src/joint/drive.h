#pragma once
// What the effort column of a log is, and how it becomes torque at the motor shaft.

#include <optional>
#include <string>

namespace tribolog {

/// What the numbers of the effort column are. Never guessed: it must be stated.
enum class EffortKind {
  motor_current,  ///< Ampere; needs a torque constant (drive gain).
  motor_torque,   ///< Newton metre made by the motor.
  joint_torque,   ///< Newton metre at the joint, e.g. from a torque sensor.
  target_torque,  ///< Newton metre that a controller asks for or its model computes: not measured.
  none,           ///< No torque and no current was recorded: only the motion is known.
};

/// The shaft to which a torque or an angle is referred.
enum class Side {
  motor,  ///< Before the gear.
  joint,  ///< After the gear: the arm's side.
};

std::string to_string(EffortKind kind);
std::string to_string(Side side);

/// Gear and effort sensing of one joint.
class Drive {
 public:
  /// @param gear_ratio n = motor angle / joint angle, > 0.
  /// @param torque_constant_Nm_A newton metres per ampere on the side given; required for
  ///        EffortKind::motor_current and refused otherwise.
  /// @throw std::invalid_argument quoting the value and the rule.
  Drive(double gear_ratio, EffortKind kind, Side side,
        std::optional<double> torque_constant_Nm_A = std::nullopt);

  [[nodiscard]] double gear_ratio() const { return gear_ratio_; }
  [[nodiscard]] EffortKind kind() const { return kind_; }
  [[nodiscard]] Side side() const { return side_; }
  [[nodiscard]] std::optional<double> torque_constant_Nm_A() const { return torque_constant_; }

  /// Factor from the effort column (A or N·m) to driving torque at the motor shaft [N·m]; NaN for
  /// EffortKind::none.
  [[nodiscard]] double motor_torque_per_effort() const;

 private:
  double gear_ratio_;
  EffortKind kind_;
  Side side_;
  std::optional<double> torque_constant_;
};

}  // namespace tribolog
