#include "ingest/dataset/recording_rows.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "base/closest_match.h"
#include "base/requirements.h"
#include "ingest/dataset/log_reader.h"
#include "ingest/log/log_table.h"
#include "ingest/log/units.h"
#include "ingest/text/csv_reader.h"
#include "joint/gravity_load.h"
#include "joint/recording.h"
#include "joint/wrapped_angle.h"

namespace tribolog::ingest::dataset {

// Known further loads, subtracted from the torque of a log that is being read.

namespace {

const log::LogColumn& column_named(const log::LogTable& table, const std::string& name) {
  return *std::find_if(table.columns.begin(), table.columns.end(), [&](const log::LogColumn& c) {
    return c.header.name == name || c.header.full == name;
  });
}

/// Adds the columns that the loads of this role follow, each once, to those wanted.
void add_load_columns(const std::vector<joint::KnownLoad>& loads, joint::Role role,
                      std::vector<log::WantedColumn>& wanted) {
  for (const joint::KnownLoad& load : loads) {
    if (!load.loads(role)) continue;
    for (const std::string& name : load.angles) {
      const bool is_wanted =
          std::any_of(wanted.begin(), wanted.end(),
                      [&](const log::WantedColumn& column) { return column.name == name; });
      if (is_wanted) continue;
      wanted.push_back({name, fmt::format("the [[known_load]] of {} follows it; 'roles' there "
                                          "limits it to recordings that have the column",
                                          printable(load.stated_at))});
    }
  }
}

/// @throw InputError for a unit in the log's header that contradicts the manifest.
void refuse_unusable_load_columns(const std::vector<joint::KnownLoad>& loads, joint::Role role,
                                  const log::LogTable& table) {
  for (const joint::KnownLoad& load : loads) {
    if (!load.loads(role)) continue;
    for (const std::string& name : load.angles) {
      const log::ColumnHeader& header = column_named(table, name).header;
      const auto factor = log::find_si_factor(log::Quantity::angle, header.unit);
      if (!factor || *factor == load.radian_per_unit) continue;
      throw InputError(
          {table.file, 1, 0},
          {"unit of the column contradicts the [[known_load]] of " + printable(load.stated_at),
           in_quotes(header.full), "the unit that is stated there", ""});
    }
  }
}

/// Takes each load of the recording's role out of its torque, and counts it in the load.
/// @param rows of the table, one for each sample of the recording.
void subtract_known_loads(const log::LogTable& table, const std::vector<std::size_t>& rows,
                          double gear_ratio, std::vector<joint::KnownLoad>& loads,
                          joint::Recording& recording) {
  for (joint::KnownLoad& load : loads) {
    if (!load.loads(recording.role)) continue;
    std::vector<const std::vector<double>*> angles;
    for (const std::string& name : load.angles) {
      angles.push_back(&column_named(table, name).values);
    }
    for (std::size_t i = 0; i < rows.size(); ++i) {
      double sum_rad = 0;
      for (const auto* angle : angles) sum_rad += (*angle)[rows[i]] * load.radian_per_unit;
      const double torque_Nm = load.torque_Nm(sum_rad);
      recording.torque_Nm[i] -= torque_Nm / gear_ratio;
      load.largest_Nm = std::max(load.largest_Nm, std::abs(torque_Nm));
    }
    load.samples += rows.size();
  }
}

constexpr double many_gaps = 0.2;  ///< Share of a column from which on a remark is made.
constexpr const char* without_effort = "without torque or current nothing can be identified";

std::vector<double>& signal_of(joint::Recording& r, joint::LoggedSignal signal) {
  switch (signal) {
    case joint::LoggedSignal::time:
    case joint::LoggedSignal::load:  // of friction points alone
      break;
    case joint::LoggedSignal::angle:
      return r.q_rad;
    case joint::LoggedSignal::speed:
      return r.dq_rad_s;
    case joint::LoggedSignal::effort:
      return r.torque_Nm;
    case joint::LoggedSignal::bristle:
      return r.z_rad;
    case joint::LoggedSignal::bristle_rate:
      return r.dz_rad_s;
    case joint::LoggedSignal::temperature:
      return r.temperature_C;
  }
  return r.t_s;
}

void refuse_contradicting_unit(const manifest::ColumnEntry& entry,
                               const log::ColumnHeader& header) {
  const auto factor = log::find_si_factor(entry.quantity, header.unit);
  if (!factor || *factor == std::abs(entry.si_factor)) return;
  throw InputError(entry.where, {"unit contradicts the header of the log", in_quotes(entry.unit),
                                 in_quotes(header.unit) + " as in " + in_quotes(header.full), ""});
}

}  // namespace

std::vector<log::WantedColumn> columns_wanted(const manifest::RecordingEntry& entry,
                                              const std::vector<joint::KnownLoad>& loads,
                                              const std::vector<std::string>& others) {
  std::vector<log::WantedColumn> wanted;
  for (const LoggedColumn& column : logged_columns(entry.columns)) {
    const bool is_effort = column.signal == joint::LoggedSignal::effort;
    if (column.entry->rate_Hz) continue;  // the clock is made (log_reader.h)
    wanted.push_back({column.entry->name, is_effort ? without_effort : "", column.entry->reading});
  }
  if (entry.time_to_compare) wanted.push_back(*entry.time_to_compare);
  add_load_columns(loads, entry.role, wanted);
  for (const std::string& name : others) {
    const auto is_same = [&](const log::WantedColumn& column) { return column.name == name; };
    const bool is_wanted = std::any_of(wanted.begin(), wanted.end(), is_same);
    if (!is_wanted) wanted.push_back({name, "", log::ColumnReading::number, true});
  }
  const auto& time = entry.columns.time;
  if (time && time->plus) wanted.push_back({time->plus->name, "", time->plus->reading});
  if (entry.columns.rows) {
    wanted.push_back({entry.columns.rows->name, "", log::ColumnReading::words});
  }
  return wanted;
}

void refuse_unusable_columns(const manifest::RecordingEntry& entry,
                             const std::vector<joint::KnownLoad>& loads, const std::string& path,
                             const log::LogTable& table) {
  refuse_unusable_load_columns(loads, entry.role, table);
  const std::vector<LoggedColumn> stated = logged_columns(entry.columns);
  for (std::size_t k = 0; k < stated.size(); ++k) {
    const log::LogColumn& column = table.columns[k];
    refuse_contradicting_unit(*stated[k].entry, column.header);
    if (column.gaps < table.rows) continue;
    throw InputError({path, 0, 0}, {"column " + in_quotes(column.header.full) +
                                        " holds no number, only gaps (empty or nan)",
                                    "", "", ""});
  }
}

void note_reading(const log::LogTable& table, RecordingNotes& notes) {
  for (const Statement& note : table.notes) notes.add(note);
  for (const log::LogColumn& column : table.columns) {
    if (column.stands_in) continue;  // noted of its own file
    const double share = static_cast<double>(column.gaps) / static_cast<double>(table.rows);
    if (share <= many_gaps) continue;
    notes.add(
        {"reading.gaps", {{"column", in_quotes(column.header.full)}, {"percent", 100 * share}}});
  }
}

namespace {

/// The angle's column as the joint went on where it is logged modulo a period; nothing where it
/// does not wrap round.
std::optional<std::vector<double>> unwrapped_column(const manifest::ColumnEntry& column,
                                                    const log::LogTable& table,
                                                    const std::vector<double>& logged,
                                                    double seconds_per_unit,
                                                    const joint::Drive& drive,
                                                    RecordingNotes& notes) {
  const std::vector<double>& clock = table.columns.front().values;
  const double turn = 2 * std::numbers::pi / std::abs(column.si_factor);
  const std::optional<joint::AngleWraps> wraps =
      joint::find_wraps(clock, logged, {turn, turn / drive.gear_ratio()});
  if (!wraps) return std::nullopt;
  notes.add({"reading.angle_unwrapped",
             {{"jumps", wraps->jumps.size()},
              {"first_s", seconds_per_unit * clock[wraps->jumps.front().sample]},
              {"period", wraps->period},
              {"unit", printable(column.unit)}}});
  return joint::unwrapped(logged, *wraps);
}

}  // namespace

joint::Recording make_recording(const manifest::RecordingEntry& entry, const log::LogTable& table,
                                const joint::Drive& drive, double effort_sign,
                                std::vector<Statement>& notes_of_all,
                                std::vector<joint::KnownLoad>* loads,
                                std::vector<std::size_t>* rows) {
  RecordingNotes notes(entry.name, notes_of_all);
  note_reading(table, notes);
  if (table.columns.front().origin != 0) {
    notes.add(Code{"reading.clock_from_1970"});
  }
  const RowChoice choice = choose_rows(entry, table, notes);

  joint::Recording r;
  r.name = entry.name;
  r.role = entry.role;
  r.rows_read = table.rows + table.cut_rows + table.bad_rows + table.unclear_rows +
                table.other_rows + table.rows_of_others;
  r.skipped = choice.skipped;
  const std::vector<LoggedColumn> columns = logged_columns(entry.columns);
  for (std::size_t k = 0; k < columns.size(); ++k) {
    const manifest::ColumnEntry& column = *columns[k].entry;
    std::optional<std::vector<double>> gone_on;
    if (columns[k].signal == joint::LoggedSignal::angle) {
      gone_on = unwrapped_column(column, table, table.columns[k].values,
                                 present(entry.columns.time).si_factor, drive, notes);
    }
    const std::vector<double>& logged = gone_on ? *gone_on : table.columns[k].values;
    const log::LogTable& stands_in =
        table.columns[k].stands_in ? *table.columns[k].stands_in : table;
    const double factor = conversion_of(columns[k], drive, effort_sign).factor();
    const double bound = largest_possible(column);
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
  if (rows != nullptr) *rows = choice.rows;
  judge_units(entry, table, drive, r, notes);
  return r;
}

}  // namespace tribolog::ingest::dataset
