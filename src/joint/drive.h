#pragma once
// What the effort column of a log is, and how columns become signals in SI at the motor shaft.

#include <optional>
#include <string>
#include <vector>

namespace tribolog::joint {

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
  /// @throw Refusal stating the value and the rule.
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

// How a column of a log becomes a signal: the factors from its unit to SI, from its sign, from
// current to torque and across the gear. The same object is applied to every row and shown in the
// report.

enum class LoggedSignal { time, angle, speed, effort, bristle, bristle_rate, temperature, load };

std::string to_string(LoggedSignal signal);

/// One factor on the way; those of 1 are left out.
struct ConversionStep {
  enum class Reason {
    unit,             ///< From the unit of the log to SI.
    sign,             ///< Of the effort, as the manifest states it.
    torque_constant,  ///< From ampere to newton metre.
    gear,             ///< To the other side of the gear.
  };
  Reason reason{};
  double number{1.0};
  bool divides{};  ///< The value is divided by the number, not multiplied.

  bool operator==(const ConversionStep&) const = default;
};

std::string to_string(ConversionStep::Reason reason);

/// The product of the steps, in their order; 1 of none.
double factor_of(const std::vector<ConversionStep>& steps);

struct ColumnConversion {
  LoggedSignal signal{};
  std::string column;  ///< As the manifest names it.
  std::string unit;    ///< In the log, as the manifest states it.
  std::vector<ConversionStep> steps;
  std::string si_unit;       ///< "rad", "N·m"
  std::optional<Side> side;  ///< To which the signal is referred; absent where it has none.
  bool is_proposed{};        ///< The unit was proposed by a program, and nobody confirmed it.

  /// From the number in the log to the signal.
  [[nodiscard]] double factor() const { return factor_of(steps); }
  bool operator==(const ColumnConversion&) const = default;
};

/// From an effort in A or N·m to torque at the motor shaft.
/// @param drive of any kind but EffortKind::none.
std::vector<ConversionStep> steps_to_motor_torque(const Drive& drive);

}  // namespace tribolog::joint
