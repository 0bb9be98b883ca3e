#include "joint/column_conversion.h"

namespace tribolog {

std::string to_string(LoggedSignal signal) {
  switch (signal) {
    case LoggedSignal::time:
      return "time";
    case LoggedSignal::angle:
      return "angle";
    case LoggedSignal::speed:
      return "speed";
    case LoggedSignal::effort:
      return "effort";
    case LoggedSignal::bristle:
      return "bristle";
    case LoggedSignal::bristle_rate:
      return "bristle_rate";
    case LoggedSignal::temperature:
      return "temperature";
  }
  return "unknown";
}

std::string to_string(ConversionStep::Reason reason) {
  switch (reason) {
    case ConversionStep::Reason::unit:
      return "unit";
    case ConversionStep::Reason::sign:
      return "sign";
    case ConversionStep::Reason::torque_constant:
      return "torque_constant";
    case ConversionStep::Reason::gear:
      return "gear";
  }
  return "unknown";
}

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

}  // namespace tribolog
