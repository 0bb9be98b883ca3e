#include "ingest/recording_rows.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "ingest/closest_match.h"

namespace tribolog {
namespace {

constexpr std::size_t fewest_rows = 20;
constexpr double largest_step_back_s = 1.0;    ///< Beyond: two logs, not a clock being set.
constexpr double most_repeated_stamps = 0.05;  ///< Share of the rows.
constexpr double many_gaps = 0.2;  ///< Share of a column from which on the user is told.
constexpr double likely_largest_angle_rad = 7.0;
constexpr double slowest_likely_Hz = 10.0;
constexpr double fastest_likely_Hz = 1e5;
constexpr const char* without_effort = "without torque or current nothing can be identified";

/// The columns in the order in which they are read from the file.
std::vector<const ColumnEntry*> entries_in_order(const ColumnEntries& c) {
  std::vector<const ColumnEntry*> entries;
  for (const auto* entry : {&c.time, &c.angle, &c.effort, &c.speed, &c.bristle, &c.bristle_rate}) {
    if (entry->has_value()) entries.push_back(&**entry);
  }
  return entries;
}

/// "recording.csv: note"
class Notes {
 public:
  Notes(const std::string& file, std::vector<std::string>& notes) : file_(file), notes_(notes) {}
  void add(const std::string& note) { notes_.push_back(printable(file_) + ": " + note); }

 private:
  const std::string& file_;
  std::vector<std::string>& notes_;
};

void refuse_contradicting_unit(const ColumnEntry& entry, const ColumnHeader& header) {
  const auto factor = find_si_factor(entry.quantity, header.unit);
  if (!factor || *factor == entry.si_factor) return;
  throw InputError(entry.where, {"unit contradicts the header of the log", in_quotes(entry.unit),
                                 in_quotes(header.unit) + " as in " + in_quotes(header.full), ""});
}

/// Rows in use, as indices into the table, and the reasons why others are not.
class RowChoice {
 public:
  RowChoice(const RecordingEntry& entry, const CsvTable& table, Notes& notes)
      : entry_(entry), table_(table), notes_(notes), to_seconds_(entry.columns.time->si_factor) {}

  std::vector<std::size_t> choose() {
    refuse_long_steps_back();
    if (table_.cut_rows > 0) skip("cut off at the end of the file", table_.cut_rows);
    drop_outside_and_gaps();
    if (steps_back_ > 0) put_in_order();
    drop_repeated_stamps();
    if (rows_.size() < fewest_rows) refuse_too_few();
    return std::move(rows_);
  }
  std::vector<SkippedRows> take_skipped() { return std::move(skipped_); }

 private:
  [[nodiscard]] double time_s(std::size_t row) const {
    return table_.columns.front().values[row] * to_seconds_;
  }

  void skip(const std::string& reason, std::size_t count) {
    if (count > 0) skipped_.push_back({reason, count});
  }

  void refuse_long_steps_back() {
    double latest = -std::numeric_limits<double>::infinity();
    for (std::size_t row = 0; row < table_.rows; ++row) {
      const double t = time_s(row);
      if (std::isnan(t)) continue;
      if (latest - t > largest_step_back_s) {
        throw InputError({table_.file, table_.line_of(row), 0},
                         {fmt::format("time runs back by {:.6g} s", latest - t), "", "",
                          "two logs concatenated? split the file, or correct the unit of time"});
      }
      if (t < latest && steps_back_++ == 0) first_back_line_ = table_.line_of(row);
      latest = std::max(latest, t);
    }
  }

  void drop_outside_and_gaps() {
    const double from = entry_.from_s.value_or(-std::numeric_limits<double>::infinity());
    const double to = entry_.to_s.value_or(std::numeric_limits<double>::infinity());
    std::size_t outside = 0;
    std::vector<std::size_t> gaps(table_.columns.size());
    for (std::size_t row = 0; row < table_.rows; ++row) {
      const double t = time_s(row);
      if (t < from || t > to) {
        ++outside;
        continue;
      }
      const auto gap =
          std::find_if(table_.columns.begin(), table_.columns.end(),
                       [row](const CsvColumn& column) { return std::isnan(column.values[row]); });
      if (gap == table_.columns.end()) {
        rows_.push_back(row);
      } else {
        ++gaps[static_cast<std::size_t>(gap - table_.columns.begin())];
      }
    }
    skip("outside the window " + window(), outside);
    for (std::size_t k = 0; k < gaps.size(); ++k) {
      skip(fmt::format("gap (nan) in column {}", in_quotes(table_.columns[k].header.full)),
           gaps[k]);
    }
  }

  [[nodiscard]] std::string window() const {
    return fmt::format("{}..{} s", entry_.from_s ? fmt::format("{}", *entry_.from_s) : "",
                       entry_.to_s ? fmt::format("{}", *entry_.to_s) : "");
  }

  void put_in_order() {
    std::stable_sort(rows_.begin(), rows_.end(),
                     [this](std::size_t a, std::size_t b) { return time_s(a) < time_s(b); });
    notes_.add(fmt::format("time runs back in {} row{} (first in line {}); put in order of time",
                           steps_back_, steps_back_ == 1 ? "" : "s", first_back_line_));
  }

  void drop_repeated_stamps() {
    const auto same_time = [this](std::size_t a, std::size_t b) { return time_s(a) == time_s(b); };
    const std::size_t before = rows_.size();
    rows_.erase(std::unique(rows_.begin(), rows_.end(), same_time), rows_.end());
    const std::size_t repeated = before - rows_.size();
    skip("repeated time stamp", repeated);
    if (static_cast<double>(repeated) <= most_repeated_stamps * static_cast<double>(before)) return;
    throw InputError({table_.file, 0, 0},
                     {fmt::format("column {}: {} of {} time stamps repeat an earlier one",
                                  in_quotes(table_.columns.front().header.full), repeated, before),
                      "", "no more than 5 %", "time column has too few digits?"});
  }

  [[noreturn]] void refuse_too_few() const {
    std::string reasons;
    for (const SkippedRows& skipped : skipped_) {
      reasons += fmt::format("{}{}: {}", reasons.empty() ? "left out: " : ", ", skipped.reason,
                             skipped.count);
    }
    throw InputError({table_.file, 0, 0},
                     {"too few usable rows", fmt::format("{} of {}", rows_.size(), table_.rows),
                      fmt::format("at least {}", fewest_rows), reasons});
  }

  const RecordingEntry& entry_;
  const CsvTable& table_;
  Notes& notes_;
  double to_seconds_;
  std::size_t steps_back_{0};
  long first_back_line_{0};
  std::vector<std::size_t> rows_;
  std::vector<SkippedRows> skipped_;
};

[[noreturn]] void refuse_too_large(const ColumnEntry& column, const CsvTable& table,
                                   std::size_t row) {
  throw InputError({table.file, table.line_of(row), 0},
                   {fmt::format("column {}: number is too large in {}", in_quotes(column.name),
                                printable(column.unit)),
                    "", "", ""});
}

void note_gaps(const CsvTable& table, Notes& notes) {
  for (const CsvColumn& column : table.columns) {
    const double share = static_cast<double>(column.gaps) / static_cast<double>(table.rows);
    if (share <= many_gaps) continue;
    notes.add(fmt::format("column {}: {:.0f} % of the rows are gaps (nan)",
                          in_quotes(column.header.full), 100 * share));
  }
}

void note_implausible_units(const RecordingEntry& entry, const Recording& r, Notes& notes) {
  const double largest =
      std::abs(*std::max_element(r.q_rad.begin(), r.q_rad.end(),
                                 [](double a, double b) { return std::abs(a) < std::abs(b); }));
  const std::string& unit = entry.columns.angle->unit;
  if (largest > likely_largest_angle_rad) {
    notes.add(fmt::format("the joint's angle reaches {:.4g} rad, read as {}: degrees?", largest,
                          printable(unit)));
  }
  const double rate_Hz = static_cast<double>(r.size() - 1) / (r.t_s.back() - r.t_s.front());
  if (rate_Hz < slowest_likely_Hz || rate_Hz > fastest_likely_Hz) {
    notes.add(fmt::format("{:.3g} samples a second, read in {}: another unit of time?", rate_Hz,
                          printable(entry.columns.time->unit)));
  }
}

}  // namespace

CsvTable read_columns_of(const RecordingEntry& entry, std::string_view bytes,
                         const std::string& path) {
  const auto entries = entries_in_order(entry.columns);
  std::vector<WantedColumn> wanted;
  for (const ColumnEntry* column : entries) {
    const bool is_effort = column == &*entry.columns.effort;
    wanted.push_back({column->name, is_effort ? without_effort : ""});
  }
  CsvTable table = read_csv(bytes, path, wanted);
  for (std::size_t k = 0; k < entries.size(); ++k) {
    const CsvColumn& column = table.columns[k];
    refuse_contradicting_unit(*entries[k], column.header);
    if (column.gaps < table.rows) continue;
    throw InputError({path, 0, 0}, {"column " + in_quotes(column.header.full) +
                                        " holds no number, only gaps (empty or nan)",
                                    "", "", ""});
  }
  return table;
}

Recording make_recording(const RecordingEntry& entry, const CsvTable& table, const Drive& drive,
                         double effort_sign, std::vector<std::string>& notes_of_all) {
  Notes notes(entry.file, notes_of_all);
  for (const std::string& note : table.notes) notes.add(note);
  note_gaps(table, notes);
  RowChoice choice(entry, table, notes);
  const std::vector<std::size_t> rows = choice.choose();

  Recording r;
  r.name = entry.file;
  r.role = entry.role;
  r.rows_read = table.rows + table.cut_rows;
  r.skipped = choice.take_skipped();
  std::size_t next_column = 0;
  const auto take = [&](const std::optional<ColumnEntry>& column, double factor) {
    std::vector<double> values;
    if (!column) return values;
    const std::vector<double>& source = table.columns[next_column++].values;
    const double gear = column->side == Side::motor ? drive.gear_ratio() : 1.0;
    values.reserve(rows.size());
    for (const std::size_t row : rows) {
      values.push_back(source[row] * column->si_factor * factor / gear);
      if (!std::isfinite(values.back())) refuse_too_large(*column, table, row);
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
  note_implausible_units(entry, r, notes);
  return r;
}

}  // namespace tribolog
