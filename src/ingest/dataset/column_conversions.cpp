#include "ingest/dataset/column_conversions.h"

#include <array>
#include <optional>
#include <utility>

namespace tribolog {
namespace {

using Reason = ConversionStep::Reason;

const char* si_unit_of(LoggedSignal signal) {
  switch (signal) {
    case LoggedSignal::time:
      return "s";
    case LoggedSignal::angle:
    case LoggedSignal::bristle:
      return "rad";
    case LoggedSignal::speed:
    case LoggedSignal::bristle_rate:
      return "rad/s";
    case LoggedSignal::effort:
      return "N·m";
    case LoggedSignal::temperature:
      return "°C";
  }
  return "";
}

void refer_to_joint(ColumnConversion& conversion, Side logged, double gear_ratio) {
  conversion.side = Side::joint;
  if (logged == Side::motor && gear_ratio != 1) {
    conversion.steps.push_back({Reason::gear, gear_ratio, true});
  }
}

void make_motor_torque(ColumnConversion& conversion, const Drive& drive, double effort_sign) {
  conversion.side = Side::motor;
  if (effort_sign != 1) conversion.steps.push_back({Reason::sign, effort_sign});
  for (const ConversionStep& step : steps_to_motor_torque(drive)) conversion.steps.push_back(step);
}

}  // namespace

std::vector<LoggedColumn> logged_columns(const ColumnEntries& c) {
  using enum LoggedSignal;
  using Column = std::pair<LoggedSignal, const std::optional<ColumnEntry>*>;
  const std::array in_order = {Column{time, &c.time},
                               Column{angle, &c.angle},
                               Column{effort, &c.effort},
                               Column{speed, &c.speed},
                               Column{bristle, &c.bristle},
                               Column{bristle_rate, &c.bristle_rate},
                               Column{temperature, &c.temperature}};
  std::vector<LoggedColumn> columns;
  for (const auto& [signal, entry] : in_order) {
    if (entry->has_value()) columns.push_back({signal, &**entry});
  }
  return columns;
}

ColumnConversion conversion_of(const LoggedColumn& column, const Drive& drive, double effort_sign) {
  const ColumnEntry& entry = *column.entry;
  ColumnConversion conversion{column.signal, entry.name, entry.unit, {}, si_unit_of(column.signal),
                              std::nullopt};
  if (entry.si_factor != 1) conversion.steps.push_back({Reason::unit, entry.si_factor});
  switch (column.signal) {
    case LoggedSignal::angle:
    case LoggedSignal::speed:
      refer_to_joint(conversion, entry.side, drive.gear_ratio());
      break;
    case LoggedSignal::effort:
      make_motor_torque(conversion, drive, effort_sign);
      break;
    case LoggedSignal::bristle:
    case LoggedSignal::bristle_rate:
      conversion.side = Side::motor;
      break;
    case LoggedSignal::time:
    case LoggedSignal::temperature:
      break;
  }
  return conversion;
}

std::vector<ColumnConversion> conversions_of(const ColumnEntries& columns, const Drive& drive,
                                             double effort_sign) {
  std::vector<ColumnConversion> conversions;
  for (const LoggedColumn& column : logged_columns(columns)) {
    conversions.push_back(conversion_of(column, drive, effort_sign));
  }
  return conversions;
}

}  // namespace tribolog
