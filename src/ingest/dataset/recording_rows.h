#pragma once
// A log's columns to a recording: SI, joint-side angle, motor-side torque, time strictly rising.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/input_file.h"
#include "base/statement.h"
#include "ingest/log/log_table.h"
#include "ingest/manifest/manifest_file.h"
#include "ingest/manifest/manifest_tables.h"
#include "joint/drive.h"
#include "joint/recording.h"

namespace tribolog::ingest::dataset {

// The columns that a manifest names, with what makes signals of them.

struct LoggedColumn {
  joint::LoggedSignal signal{};
  const manifest::ColumnEntry* entry{};  ///< Of the manifest; not null.
};

/// In the order in which they are read; the time comes first.
std::vector<LoggedColumn> logged_columns(const manifest::ColumnEntries& columns);

/// Angle and speed to the joint's side, effort to torque at the motor, all to SI.
/// @param effort_sign 1 or -1.
joint::ColumnConversion conversion_of(const LoggedColumn& column, const joint::Drive& drive,
                                      double effort_sign);

/// Those of all columns, in the same order.
std::vector<joint::ColumnConversion> conversions_of(const manifest::ColumnEntries& columns,
                                                    const joint::Drive& drive, double effort_sign);

// Which rows of a log become samples, in which order, and why the others do not.

/// Notes of one recording, each as "<file>: <note>"; what several recordings of a file have in
/// common is noted once.
class RecordingNotes {
 public:
  RecordingNotes(const std::string& file, std::vector<Statement>& notes)
      : file_(file), notes_(notes) {}
  void add(const Statement& note);
  /// Whether the file has a note of this kind: what is true of many of its recordings is said of
  /// the first.
  [[nodiscard]] bool has(Code kind) const;

 private:
  const std::string& file_;
  std::vector<Statement>& notes_;
};

/// Rows left out as those of another time: with a file of several recordings, most of them.
bool is_outside_window(const joint::SkippedRows& skipped);
/// Rows that every recording of the file lacks, whatever its window.
bool is_of_whole_file(const joint::SkippedRows& skipped);

struct RowChoice {
  std::vector<std::size_t> rows;            ///< Of the table; their times rise strictly.
  std::vector<joint::SkippedRows> skipped;  ///< All of the log = rows.size() + their sum.
};

/// @param table its first column is the time; a gap in any column leaves the row out.
/// @throw InputError if time runs back by more than a second, more than 5 % of the time stamps
/// stand
///        twice, or fewer than 20 rows are left.
RowChoice choose_rows(const manifest::RecordingEntry& entry, const log::LogTable& table,
                      RecordingNotes& notes);

// Numbers that no joint of a robot gives, whatever was measured: a damaged row, another unit.

/// Rates between which a recording is read unless the manifest states any_rate: controllers log
/// 10 Hz to 8 kHz; half of the slowest leaves room for dropouts.
inline constexpr double slowest_rate_Hz = 5.0;
inline constexpr double fastest_rate_Hz = 1e5;

/// Of a column's values, in SI and on the side on which they were logged; infinite for the time.
double largest_possible(log::Quantity quantity);
/// The same in the column's own unit.
double largest_possible(const manifest::ColumnEntry& column);

/// @throw InputError at the row's line: its value in this column is no number that a joint has.
[[noreturn]] void refuse_impossible_value(const manifest::ColumnEntry& column, double value,
                                          const log::LogTable& table, std::size_t row);

/// The rows of a column whose value is beyond `bound`, in its own unit.
std::vector<std::size_t> rows_beyond(const std::vector<double>& values, double bound);

/// Makes gaps of such values, which are counted apart from others.
/// @param table with the columns wanted; a copy is made where there is something to blank.
/// @return the copy; nothing where no value is impossible.
/// @throw InputError at the first of them, where they are more than 1 % of the rows.
std::optional<log::LogTable> without_impossible_values(const manifest::RecordingEntry& entry,
                                                       const log::LogTable& table);

/// Notes what points to another unit: an angle of more than a turn, a torque larger than that of
/// the largest robots, few samples a second.
/// @throw InputError for under 5 or over 100 000 samples a second (the median), unless the manifest
///        states that this is right; with the units of time in which there would be a usual number.
void judge_units(const manifest::RecordingEntry& entry, const log::LogTable& table,
                 const joint::Drive& drive, const joint::Recording& recording,
                 RecordingNotes& notes);

// The recording.

/// The columns that the entry names, in the order of logged_columns(), but for a clock that is
/// made; behind them the time to compare, the angles of the loads that load the recording, those of
/// the robot's other joints that are not among these, which are optional, the second part of the
/// clock, and what tells whose row it is.
/// @param others columns; none is read where each row is one joint's.
std::vector<log::WantedColumn> columns_wanted(const manifest::RecordingEntry& entry,
                                              const std::vector<joint::KnownLoad>& loads = {},
                                              const std::vector<std::string>& others = {});

/// @param table with the columns wanted.
/// @param path of the log, for messages.
/// @throw InputError for a column that is nothing but gaps, and a unit in the log's header that
///        contradicts the manifest.
void refuse_unusable_columns(const manifest::RecordingEntry& entry,
                             const std::vector<joint::KnownLoad>& loads, const std::string& path,
                             const log::LogTable& table);

/// What was peculiar when the table was read, and which of its columns have many gaps.
void note_reading(const log::LogTable& table, RecordingNotes& notes);

/// Rows outside the window, with a gap, or with a time stamp that stood before are left out and
/// counted in `skipped`. Time running back by up to a second is put in order.
/// @param notes receives what the user should know.
/// @param loads those that load the recording are subtracted from its torque and count it.
/// An angle that wraps round goes on, in the whole log and so in each window of it.
/// @throw InputError if time runs back further, more than 5 % of the time stamps stand twice, or
///        fewer than 20 rows are left.
/// @param rows receives the rows of the table that became samples.
joint::Recording make_recording(const manifest::RecordingEntry& entry, const log::LogTable& table,
                                const joint::Drive& drive, double effort_sign,
                                std::vector<Statement>& notes,
                                std::vector<joint::KnownLoad>* loads = nullptr,
                                std::vector<std::size_t>* rows = nullptr);

// Friction points.

/// Points at rest or with a gap in any column are left out and counted. More than 2,000 become as
/// many means of neighbours in speed, which a note says.
/// @throw InputError for fewer than three points, and where more than half of a direction's torque
///        is against the speed: then it is no friction, or its sign is another.
joint::FrictionPoints make_friction_points(const manifest::RecordingEntry& entry,
                                           const log::LogTable& table, const joint::Drive& drive,
                                           double effort_sign, std::vector<Statement>& notes);

}  // namespace tribolog::ingest::dataset
