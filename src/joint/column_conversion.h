#pragma once
// How a column of a log becomes a signal: the factors from its unit to SI, from its sign, from
// current to torque and across the gear. The same object is applied to every row and shown in the
// report.

#include <optional>
#include <string>
#include <vector>

#include "joint/drive.h"

namespace tribolog {

enum class LoggedSignal { time, angle, speed, effort, bristle, bristle_rate, temperature };

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

  /// From the number in the log to the signal.
  [[nodiscard]] double factor() const { return factor_of(steps); }
  bool operator==(const ColumnConversion&) const = default;
};

/// From an effort in A or N·m to torque at the motor shaft.
/// @param drive of any kind but EffortKind::none.
std::vector<ConversionStep> steps_to_motor_torque(const Drive& drive);

}  // namespace tribolog
