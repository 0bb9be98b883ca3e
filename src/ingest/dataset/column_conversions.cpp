#include <array>
#include <optional>
#include <utility>

#include "base/enum_text.h"
#include "ingest/dataset/recording_rows.h"

namespace tribolog::ingest::dataset {
namespace {

using Reason = joint::ConversionStep::Reason;

std::string si_unit_of(joint::LoggedSignal signal) {
  constexpr EnumTexts<joint::LoggedSignal> units("s", "rad", "rad/s", "N·m", "rad", "rad/s", "°C",
                                                 "N·m");
  return std::string(units.of(signal));
}

void refer_to_joint(joint::ColumnConversion& conversion, joint::Side logged, double gear_ratio) {
  conversion.side = joint::Side::joint;
  if (logged == joint::Side::motor && gear_ratio != 1) {
    conversion.steps.push_back({Reason::gear, gear_ratio, true});
  }
}

void refer_to_motor(joint::ColumnConversion& conversion, joint::Side logged, double gear_ratio) {
  conversion.side = joint::Side::motor;
  if (logged == joint::Side::joint && gear_ratio != 1) {
    conversion.steps.push_back({Reason::gear, gear_ratio, true});
  }
}

void make_motor_torque(joint::ColumnConversion& conversion, const joint::Drive& drive,
                       double effort_sign) {
  conversion.side = joint::Side::motor;
  if (effort_sign != 1) conversion.steps.push_back({Reason::sign, effort_sign});
  for (const joint::ConversionStep& step : joint::steps_to_motor_torque(drive))
    conversion.steps.push_back(step);
}

}  // namespace

std::vector<LoggedColumn> logged_columns(const manifest::ColumnEntries& c) {
  using enum joint::LoggedSignal;
  using Column = std::pair<joint::LoggedSignal, const std::optional<manifest::ColumnEntry>*>;
  const std::array in_order = {Column{time, &c.time},
                               Column{angle, &c.angle},
                               Column{effort, &c.effort},
                               Column{speed, &c.speed},
                               Column{bristle, &c.bristle},
                               Column{bristle_rate, &c.bristle_rate},
                               Column{temperature, &c.temperature},
                               Column{load, &c.load}};
  std::vector<LoggedColumn> columns;
  for (const auto& [signal, entry] : in_order) {
    if (entry->has_value()) columns.push_back({signal, &**entry});
  }
  return columns;
}

joint::ColumnConversion conversion_of(const LoggedColumn& column, const joint::Drive& drive,
                                      double effort_sign) {
  const manifest::ColumnEntry& entry = *column.entry;
  joint::ColumnConversion conversion{
      column.signal, entry.name,       entry.unit, {}, si_unit_of(column.signal),
      std::nullopt,  entry.is_proposed};
  if (entry.si_factor != 1) conversion.steps.push_back({Reason::unit, entry.si_factor});
  switch (column.signal) {
    case joint::LoggedSignal::angle:
    case joint::LoggedSignal::speed:
      refer_to_joint(conversion, entry.side, drive.gear_ratio());
      break;
    case joint::LoggedSignal::effort:
      make_motor_torque(conversion, drive, effort_sign);
      break;
    case joint::LoggedSignal::load:
      refer_to_motor(conversion, entry.side, drive.gear_ratio());
      break;
    case joint::LoggedSignal::bristle:
    case joint::LoggedSignal::bristle_rate:
      conversion.side = joint::Side::motor;
      break;
    case joint::LoggedSignal::time:
    case joint::LoggedSignal::temperature:
      break;
  }
  return conversion;
}

std::vector<joint::ColumnConversion> conversions_of(const manifest::ColumnEntries& columns,
                                                    const joint::Drive& drive, double effort_sign) {
  std::vector<joint::ColumnConversion> conversions;
  for (const LoggedColumn& column : logged_columns(columns)) {
    conversions.push_back(conversion_of(column, drive, effort_sign));
  }
  return conversions;
}

}  // namespace tribolog::ingest::dataset
