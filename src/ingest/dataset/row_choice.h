#pragma once
// Which rows of a log become samples, in which order, and why the others do not.

#include <cstddef>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/statement.h"
#include "ingest/log/log_table.h"
#include "ingest/manifest/manifest_file.h"
#include "joint/drive.h"
#include "joint/recording.h"

namespace tribolog::ingest::dataset {

/// Notes of one recording, each as "<file>: <note>"; what several recordings of a file have in
/// common is noted once.
class RecordingNotes {
 public:
  RecordingNotes(const std::string& file, std::vector<Statement>& notes)
      : file_(file), notes_(notes) {}
  void add(const Statement& note);

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

/// Of a column's values, in SI and on the side on which they were logged; infinite for the time.
double largest_possible(log::Quantity quantity);

/// @throw InputError at the row's line: its value in this column is no number that a joint has.
[[noreturn]] void refuse_impossible_value(const manifest::ColumnEntry& column, double value,
                                          const log::LogTable& table, std::size_t row);

/// Notes what points to another unit: an angle of more than a turn or that wraps round, a torque
/// larger than that of the largest robots, few samples a second.
/// @throw InputError for under 5 or over 100 000 samples a second (the median), unless the manifest
///        states that this is right; with the units of time in which there would be a usual number.
void judge_units(const manifest::RecordingEntry& entry, const log::LogTable& table,
                 const joint::Drive& drive, const joint::Recording& recording,
                 RecordingNotes& notes);

}  // namespace tribolog::ingest::dataset
