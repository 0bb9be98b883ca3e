#include "ingest/dataset/recording_rows.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/closest_match.h"
#include "ingest/dataset/column_conversions.h"
#include "ingest/dataset/known_load_rows.h"
#include "ingest/dataset/log_reader.h"
#include "ingest/dataset/plausible_values.h"
#include "ingest/dataset/row_choice.h"
#include "ingest/text/csv_reader.h"

namespace tribolog {
namespace {

constexpr double many_gaps = 0.2;  ///< Share of a column from which on the user is told.
constexpr const char* without_effort = "without torque or current nothing can be identified";

std::vector<double>& signal_of(Recording& r, LoggedSignal signal) {
  switch (signal) {
    case LoggedSignal::time:
      break;
    case LoggedSignal::angle:
      return r.q_rad;
    case LoggedSignal::speed:
      return r.dq_rad_s;
    case LoggedSignal::effort:
      return r.torque_Nm;
    case LoggedSignal::bristle:
      return r.z_rad;
    case LoggedSignal::bristle_rate:
      return r.dz_rad_s;
    case LoggedSignal::temperature:
      return r.temperature_C;
  }
  return r.t_s;
}

void refuse_contradicting_unit(const ColumnEntry& entry, const ColumnHeader& header) {
  const auto factor = find_si_factor(entry.quantity, header.unit);
  if (!factor || *factor == entry.si_factor) return;
  throw InputError(entry.where, {"unit contradicts the header of the log", in_quotes(entry.unit),
                                 in_quotes(header.unit) + " as in " + in_quotes(header.full), ""});
}

}  // namespace

std::vector<WantedColumn> columns_wanted(const RecordingEntry& entry,
                                         const std::vector<KnownLoad>& loads) {
  std::vector<WantedColumn> wanted;
  for (const LoggedColumn& column : logged_columns(entry.columns)) {
    const bool is_effort = column.signal == LoggedSignal::effort;
    wanted.push_back({column.entry->name, is_effort ? without_effort : "", column.entry->reading});
  }
  if (entry.time_to_compare) wanted.push_back(*entry.time_to_compare);
  add_load_columns(loads, entry.role, wanted);
  return wanted;
}

void refuse_unusable_columns(const RecordingEntry& entry, const std::vector<KnownLoad>& loads,
                             const std::string& path, const LogTable& table) {
  refuse_unusable_load_columns(loads, entry.role, table);
  const std::vector<LoggedColumn> stated = logged_columns(entry.columns);
  for (std::size_t k = 0; k < stated.size(); ++k) {
    const LogColumn& column = table.columns[k];
    refuse_contradicting_unit(*stated[k].entry, column.header);
    if (column.gaps < table.rows) continue;
    throw InputError({path, 0, 0}, {"column " + in_quotes(column.header.full) +
                                        " holds no number, only gaps (empty or nan)",
                                    "", "", ""});
  }
}

void note_reading(const LogTable& table, RecordingNotes& notes) {
  for (const std::string& note : table.notes) notes.add(note);
  for (const LogColumn& column : table.columns) {
    if (column.stands_in) continue;  // noted of its own file
    const double share = static_cast<double>(column.gaps) / static_cast<double>(table.rows);
    if (share <= many_gaps) continue;
    notes.add(fmt::format("column {}: {:.0f} % of the rows are gaps (nan)",
                          in_quotes(column.header.full), 100 * share));
  }
}

Recording make_recording(const RecordingEntry& entry, const LogTable& table, const Drive& drive,
                         double effort_sign, std::vector<std::string>& notes_of_all,
                         std::vector<KnownLoad>* loads) {
  RecordingNotes notes(entry.file, notes_of_all);
  note_reading(table, notes);
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
  const std::vector<LoggedColumn> columns = logged_columns(entry.columns);
  for (std::size_t k = 0; k < columns.size(); ++k) {
    const ColumnEntry& column = *columns[k].entry;
    const std::vector<double>& logged = table.columns[k].values;
    const LogTable& stands_in = table.columns[k].stands_in ? *table.columns[k].stands_in : table;
    const double factor = conversion_of(columns[k], drive, effort_sign).factor();
    const double bound = largest_possible(column.quantity) / column.si_factor;
    std::vector<double>& signal = signal_of(r, columns[k].signal);
    signal.reserve(choice.rows.size());
    for (const std::size_t row : choice.rows) {
      signal.push_back(logged[row] * factor);
      if (!(std::abs(logged[row]) <= bound)) {
        refuse_impossible_value(column, logged[row], stands_in, row);
      }
    }
  }
  if (loads != nullptr) subtract_known_loads(table, choice.rows, drive.gear_ratio(), *loads, r);
  judge_units(entry, table, drive, r, notes);
  return r;
}

}  // namespace tribolog
