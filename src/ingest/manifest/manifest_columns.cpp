#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include <fmt/format.h>

#include "base/closest_match.h"
#include "ingest/log/row_clock.h"
#include "ingest/manifest/manifest_tables.h"

namespace tribolog::ingest::manifest {

namespace {

constexpr std::array<std::string_view, 8> kinds = {
    "motor_voltage", "voltage", "input_voltage", "pwm", "motor_pwm", "duty", "duty_cycle", "PWM"};
constexpr std::array<std::string_view, 8> units = {"V",   "mV",  "kV",   "%",
                                                   "PWM", "pwm", "duty", "percent"};

[[noreturn]] void refuse(const TomlTable& table, const char* key, const std::string& found) {
  table.refuse(key, {"a voltage or duty cycle is no torque", in_quotes(found),
                     "the motor's present current with its torque constant, or a torque",
                     "how much of a voltage becomes torque depends on the speed; record the "
                     "current, or state effort.kind = \"none\" and leave the column out to have "
                     "the motion checked alone"});
}

}  // namespace

void refuse_voltage_kind(const TomlTable& effort) {
  if (!effort.has("kind")) return;
  const std::string kind = effort.text("kind");
  if (std::find(kinds.begin(), kinds.end(), kind) != kinds.end()) refuse(effort, "kind", kind);
}

void refuse_voltage_unit(const TomlTable& column) {
  if (!column.has("unit")) return;
  const std::string unit = column.text("unit");
  if (std::find(units.begin(), units.end(), unit) != units.end()) refuse(column, "unit", unit);
}

namespace {

/// The unit is of another quantity than the effort's kind says.
void refuse_contradiction(const TomlTable& column, log::Quantity quantity,
                          const std::string& unit) {
  const log::Quantity other =
      quantity == log::Quantity::current ? log::Quantity::torque : log::Quantity::current;
  if (quantity != log::Quantity::current && quantity != log::Quantity::torque) return;
  if (log::find_si_factor(quantity, unit) || !log::find_si_factor(other, unit)) return;
  column.refuse("unit", {"contradicts effort.kind", in_quotes(unit) + ", " + log::to_string(other),
                         log::to_string(quantity) + " (" + log::known_units(quantity) + ")",
                         "is the kind of the effort stated rightly?"});
}

/// Of a column that stands beside the recording's file.
void read_place(const TomlTable& column, ColumnEntry& entry) {
  if (entry.quantity == log::Quantity::time) {
    if (!column.has_misplaced("file")) return;
    column.refuse("file", {"is not for the time", "", "",
                           "the recording's file is the one that has the time; state a file for "
                           "the other columns"});
  }
  if (!column.has("file")) return;
  entry.file = column.text("file");
  if (entry.file.empty()) column.refuse("file", {"is empty", "", "the log's name", ""});
  entry.time_in_file = column.text_or("time", "");
}

/// Of a clock that stands in two columns.
std::optional<ClockPart> read_clock_part(const TomlTable& time) {
  const auto table = time.find_table("plus");
  if (!table) return std::nullopt;
  ClockPart part;
  part.name = table->text("name", "the name of the column that is added to the time");
  const std::string unit =
      table->text("unit", "one of " + log::known_units(log::Quantity::time) + ", yyyy-mm-dd");
  const auto reading = log::reading_of_time(unit);
  part.reading = reading.value_or(log::ColumnReading::number);
  if (!reading) part.si_factor = log::si_factor(log::Quantity::time, unit, table->where("unit"));
  const bool is_day = reading == log::ColumnReading::date;
  const bool is_of_day = log::reading_of_time(time.text("unit")) == log::ColumnReading::time_of_day;
  if ((reading && !is_day) || is_day != is_of_day) {
    table->refuse("unit", {"cannot be added to that of the time", in_quotes(unit),
                           is_of_day ? "yyyy-mm-dd, the date of a time of day"
                                     : "one of " + log::known_units(log::Quantity::time),
                           ""});
  }
  table->refuse_unknown_keys();
  return part;
}

std::optional<RowsEntry> read_rows(const TomlTable& columns,
                                   const std::optional<RowsEntry>& otherwise) {
  const auto table = columns.find_table("rows");
  if (!table) return otherwise;
  RowsEntry rows;
  rows.name = table->text("name", "the name of the column that tells whose a row is");
  rows.value = table->text("value", "what stands in it where a row is this joint's");
  rows.where = table->where("value");
  table->refuse_unknown_keys();
  return rows;
}

std::optional<ColumnEntry> read_column(const TomlTable& columns, const std::string& key,
                                       log::Quantity quantity, bool has_side,
                                       const std::optional<ColumnEntry>& otherwise) {
  const auto table = columns.find_table(key);
  if (!table) return otherwise;
  ColumnEntry entry;
  entry.quantity = quantity;
  if (quantity == log::Quantity::time && table->has("rate_Hz")) {
    entry.rate_Hz = table->number("rate_Hz", Sign::positive);
    entry.name = log::name_of_row_clock(*entry.rate_Hz);
    entry.unit = "s";
    entry.where = table->where("rate_Hz");
    table->refuse_unknown_keys();
    return entry;
  }
  entry.name = table->text("name", "the column's name in the file");
  if (entry.name.empty()) table->refuse("name", {"is empty", "", "the column's name", ""});
  entry.unit = table->text("unit", "one of " + log::known_units(quantity));
  refuse_contradiction(*table, quantity, entry.unit);
  if (quantity == log::Quantity::time) {
    const auto reading = log::reading_of_time(entry.unit);  // read as seconds
    entry.reading = reading.value_or(log::ColumnReading::clock);
    if (!reading) entry.si_factor = log::si_factor(quantity, entry.unit, table->where("unit"));
    entry.plus = read_clock_part(*table);
  } else {
    entry.si_factor = log::si_factor(quantity, entry.unit, table->where("unit"));
  }
  // The effort's side is stated under [effort]; its sign there or here.
  if ((has_side || key == "effort") && table->has("sign")) {
    const double sign = table->number("sign");
    if (std::abs(sign) != 1) {
      table->refuse("sign", {"is neither 1 nor -1", fmt::format("{:g}", sign), "1 or -1",
                             "-1: the column counts the other way round"});
    }
    entry.si_factor *= sign;
  }
  if (quantity == log::Quantity::time) entry.any_rate = table->flag_or("any_rate", false);
  const bool may_be_proposed = quantity == log::Quantity::time ||
                               quantity == log::Quantity::angle ||
                               quantity == log::Quantity::angular_speed;
  if (may_be_proposed) entry.is_proposed = !table->flag_or("confirmed", true);
  if (has_side && table->has("side")) {
    entry.side =
        table->choice("side", {"motor", "joint"}) == 0 ? joint::Side::motor : joint::Side::joint;
  }
  if (table->has("register")) {
    entry.of_register = log::register_named(table->text("register"));
    if (!entry.of_register) {
      table->refuse("register", {"is none that is known", in_quotes(table->text("register")),
                                 "one of " + log::register_names(), ""});
    }
  }
  read_place(*table, entry);
  entry.where = table->where("name");
  table->refuse_unknown_keys();
  return entry;
}

}  // namespace

ColumnEntries read_columns(const TomlTable& table, joint::EffortKind effort_kind,
                           const ColumnEntries& otherwise) {
  if (effort_kind == joint::EffortKind::none && table.has("effort")) {
    table.refuse("effort", {"contradicts effort.kind", "an effort, of kind 'none'", "",
                            "state what kind of effort the column is, or leave it out"});
  }
  if (const auto column = table.find_table("effort")) refuse_voltage_unit(*column);
  const log::Quantity effort = effort_kind == joint::EffortKind::motor_current
                                   ? log::Quantity::current
                                   : log::Quantity::torque;
  const auto read = [&](const char* key, log::Quantity quantity, bool has_side,
                        const auto& fallback) {
    return read_column(table, key, quantity, has_side, fallback);
  };
  ColumnEntries entries;
  entries.time = read("time", log::Quantity::time, false, otherwise.time);
  entries.angle = read("angle", log::Quantity::angle, true, otherwise.angle);
  entries.speed = read("speed", log::Quantity::angular_speed, true, otherwise.speed);
  entries.effort = read("effort", effort, false, otherwise.effort);
  entries.bristle = read("bristle", log::Quantity::angle, false, otherwise.bristle);
  entries.bristle_rate =
      read("bristle_rate", log::Quantity::angular_speed, false, otherwise.bristle_rate);
  entries.temperature =
      read("temperature", log::Quantity::temperature, false, otherwise.temperature);
  entries.load = read("load", log::Quantity::torque, true, otherwise.load);
  entries.rows = read_rows(table, otherwise.rows);
  table.refuse_unknown_keys();
  return entries;
}

}  // namespace tribolog::ingest::manifest
