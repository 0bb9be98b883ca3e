#include "joint/drive.h"

#include <limits>

#include "base/enum_text.h"
#include "base/requirements.h"
#include "base/statement.h"

namespace tribolog::joint {

std::string to_string(EffortKind kind) { return own_name(kind); }

std::string to_string(Side side) { return own_name(side); }

Drive::Drive(double gear_ratio, EffortKind kind, Side side,
             std::optional<double> torque_constant_Nm_A)
    : gear_ratio_(gear_ratio), kind_(kind), side_(side), torque_constant_(torque_constant_Nm_A) {
  require_positive(gear_ratio, "gear ratio", "");
  const bool is_current = kind == EffortKind::motor_current;
  if (is_current && !torque_constant_) throw Refusal({"drive.no_torque_constant"});
  if (!is_current && torque_constant_) {
    throw Refusal({"drive.torque_constant_of_no_current",
                   {{"torque_constant_Nm_A", *torque_constant_}, {"kind", to_string(kind)}}});
  }
  if (torque_constant_) require_positive(*torque_constant_, "torque constant", "N·m/A");
}

double Drive::motor_torque_per_effort() const {
  if (kind_ == EffortKind::none) return std::numeric_limits<double>::quiet_NaN();
  return factor_of(steps_to_motor_torque(*this));
}

std::string to_string(LoggedSignal signal) { return own_name(signal); }

std::string to_string(ConversionStep::Reason reason) { return own_name(reason); }

double factor_of(const std::vector<ConversionStep>& steps) {
  double product = 1;
  for (const ConversionStep& step : steps) {
    product = step.divides ? product / step.number : product * step.number;
  }
  return product;
}

std::vector<ConversionStep> steps_to_motor_torque(const Drive& drive) {
  std::vector<ConversionStep> steps;
  if (const auto constant = drive.torque_constant_Nm_A()) {
    steps.push_back({ConversionStep::Reason::torque_constant, *constant});
  }
  if (drive.side() == Side::joint && drive.gear_ratio() != 1) {
    steps.push_back({ConversionStep::Reason::gear, drive.gear_ratio(), true});
  }
  return steps;
}

}  // namespace tribolog::joint
