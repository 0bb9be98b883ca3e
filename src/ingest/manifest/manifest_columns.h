#pragma once
// Which column of a log is what: the `columns` table of a manifest.

#include <optional>
#include <string>

#include "base/error.h"
#include "ingest/log/log_table.h"
#include "ingest/log/units.h"
#include "ingest/manifest/toml_table.h"
#include "joint/drive.h"

namespace tribolog::ingest::manifest {

/// @throw InputError if the table's `kind` is a voltage or a duty cycle.
void refuse_voltage_kind(const TomlTable& effort);

/// @throw InputError if the column's `unit` is one of voltage or duty cycle.
void refuse_voltage_unit(const TomlTable& column);

struct ColumnEntry {
  std::string name;
  std::string unit;
  log::Quantity quantity{};
  double si_factor{1.0};
  joint::Side side{
      joint::Side::joint};  ///< Of angle and speed; bristles are always on the motor side.
  Location where;
  log::ColumnReading reading{log::ColumnReading::number};
  /// In which the column stands, relative to the manifest; empty: the recording's.
  std::string file{};
  std::string time_in_file{};  ///< Name of the time there; empty: the recording's, if it is there.
  bool any_rate{};             ///< Of the time: so stated, however many samples a second it makes.
};

struct ColumnEntries {
  std::optional<ColumnEntry> time;
  std::optional<ColumnEntry> angle;
  std::optional<ColumnEntry> speed;
  std::optional<ColumnEntry> effort;
  std::optional<ColumnEntry> bristle;
  std::optional<ColumnEntry> bristle_rate;
  std::optional<ColumnEntry> temperature;
};

/// Reads a `columns` table; what it does not mention is taken from `otherwise`.
/// @param effort_kind decides whether the effort is a current or a torque; with EffortKind::none an
///        effort is refused.
/// @throw InputError for an unknown unit, an unknown key, or a unit that contradicts the kind; for
///        an effort in volt or per cent of the duty cycle, which no torque follows from; for a file
///        of the time.
ColumnEntries read_columns(const TomlTable& table, joint::EffortKind effort_kind,
                           const ColumnEntries& otherwise);

}  // namespace tribolog::ingest::manifest
