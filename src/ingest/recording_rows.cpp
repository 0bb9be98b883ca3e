#include "ingest/recording_rows.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "ingest/closest_match.h"
#include "ingest/known_load_rows.h"
#include "ingest/log_reader.h"
#include "ingest/plausible_values.h"
#include "ingest/row_choice.h"
#include "ingest/text/csv_reader.h"

namespace tribolog {
namespace {

constexpr double many_gaps = 0.2;  ///< Share of a column from which on the user is told.
constexpr const char* without_effort = "without torque or current nothing can be identified";

/// The columns in the order in which they are read from the file.
std::vector<const ColumnEntry*> entries_in_order(const ColumnEntries& c) {
  std::vector<const ColumnEntry*> entries;
  for (const auto* entry :
       {&c.time, &c.angle, &c.effort, &c.speed, &c.bristle, &c.bristle_rate, &c.temperature}) {
    if (entry->has_value()) entries.push_back(&**entry);
  }
  return entries;
}

void refuse_contradicting_unit(const ColumnEntry& entry, const ColumnHeader& header) {
  const auto factor = find_si_factor(entry.quantity, header.unit);
  if (!factor || *factor == entry.si_factor) return;
  throw InputError(entry.where, {"unit contradicts the header of the log", in_quotes(entry.unit),
                                 in_quotes(header.unit) + " as in " + in_quotes(header.full), ""});
}

void note_gaps(const LogTable& table, RecordingNotes& notes) {
  for (const LogColumn& column : table.columns) {
    const double share = static_cast<double>(column.gaps) / static_cast<double>(table.rows);
    if (share <= many_gaps) continue;
    notes.add(fmt::format("column {}: {:.0f} % of the rows are gaps (nan)",
                          in_quotes(column.header.full), 100 * share));
  }
}

std::vector<WantedColumn> columns_wanted(const RecordingEntry& entry,
                                         const std::vector<KnownLoad>& loads) {
  std::vector<WantedColumn> wanted;
  for (const ColumnEntry* column : entries_in_order(entry.columns)) {
    const bool is_effort = entry.columns.effort && column == &*entry.columns.effort;
    wanted.push_back({column->name, is_effort ? without_effort : "", column->reading});
  }
  add_load_columns(loads, entry.role, wanted);
  return wanted;
}

void refuse_unusable_columns(const RecordingEntry& entry, const std::vector<KnownLoad>& loads,
                             const std::string& path, const LogTable& table) {
  refuse_unusable_load_columns(loads, entry.role, table);
  const auto entries = entries_in_order(entry.columns);
  for (std::size_t k = 0; k < entries.size(); ++k) {
    const LogColumn& column = table.columns[k];
    refuse_contradicting_unit(*entries[k], column.header);
    if (column.gaps < table.rows) continue;
    throw InputError({path, 0, 0}, {"column " + in_quotes(column.header.full) +
                                        " holds no number, only gaps (empty or nan)",
                                    "", "", ""});
  }
}

}  // namespace

LogTable read_columns_of(const RecordingEntry& entry, ByteSource& bytes, const std::string& path,
                         const std::vector<KnownLoad>& loads, const TextLogRules& rules) {
  LogTable table = read_csv(bytes, path, columns_wanted(entry, loads), rules);
  refuse_unusable_columns(entry, loads, path, table);
  return table;
}

LogTable choose_columns_of(const RecordingEntry& entry, std::vector<LogTable> tables,
                           const std::string& path, const std::vector<KnownLoad>& loads) {
  LogTable table = take_columns(std::move(tables), columns_wanted(entry, loads));
  refuse_unusable_columns(entry, loads, path, table);
  return table;
}

Recording make_recording(const RecordingEntry& entry, const LogTable& table, const Drive& drive,
                         double effort_sign, std::vector<std::string>& notes_of_all,
                         std::vector<KnownLoad>* loads) {
  RecordingNotes notes(entry.file, notes_of_all);
  for (const std::string& note : table.notes) notes.add(note);
  note_gaps(table, notes);
  if (table.columns.front().origin != 0) {
    notes.add(
        "its clock counts from 1970; here, and in from_s and to_s, time counts from its first "
        "reading, in whole units");
  }
  const RowChoice choice = choose_rows(entry, table, notes);

  Recording r;
  r.name = entry.file;
  r.role = entry.role;
  r.rows_read = table.rows + table.cut_rows + table.bad_rows;
  r.skipped = choice.skipped;
  std::size_t next_column = 0;
  const auto take = [&](const std::optional<ColumnEntry>& column, double factor) {
    std::vector<double> values;
    if (!column) return values;
    const std::vector<double>& source = table.columns[next_column++].values;
    const double gear = column->side == Side::motor ? drive.gear_ratio() : 1.0;
    values.reserve(choice.rows.size());
    const double bound = largest_possible(column->quantity) / column->si_factor;
    for (const std::size_t row : choice.rows) {
      values.push_back(source[row] * column->si_factor * factor / gear);
      if (!(std::abs(source[row]) <= bound)) {
        refuse_impossible_value(*column, source[row], table, row);
      }
    }
    return values;
  };
  const ColumnEntries& c = entry.columns;
  r.t_s = take(c.time, 1.0);
  r.q_rad = take(c.angle, 1.0);
  r.torque_Nm = take(c.effort, effort_sign * drive.motor_torque_per_effort());
  r.dq_rad_s = take(c.speed, 1.0);
  r.z_rad = take(c.bristle, 1.0);
  r.dz_rad_s = take(c.bristle_rate, 1.0);
  r.temperature_C = take(c.temperature, 1.0);
  if (loads != nullptr) subtract_known_loads(table, choice.rows, drive.gear_ratio(), *loads, r);
  judge_units(entry, table, drive, r, notes);
  return r;
}

}  // namespace tribolog
