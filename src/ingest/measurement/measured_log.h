#pragma once
// What both formats make of a file: tables with names that differ, and what was left out.

#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "base/statement.h"
#include "ingest/log/log_table.h"

namespace tribolog::ingest::measurement {

/// A channel that is left out; the text says why.
class UnreadChannel : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A column of these values; what is not finite is a gap.
/// @param name as the file has it: "torque [Nm]" has a unit, where there is no other.
/// @param unit where the file states one outside of the name; empty: it does not.
log::LogColumn column_of(const std::string& name, const std::string& unit,
                         std::vector<double> values);

class MeasuredLog {
 public:
  explicit MeasuredLog(std::string file) : file_(std::move(file)) {}

  [[nodiscard]] const std::string& file() const { return file_; }
  /// Something that the user should know of the whole file.
  void note(Statement note) { notes_.push_back(std::move(note)); }
  /// A channel or group that is not read.
  void leave_out(const std::string& name, const std::string& reason);
  /// A table with its columns; file, header and names that differ are put in here.
  void add(log::LogTable table);

  /// In the order in which they were added, with groups that differ; the first one has the notes.
  /// @throw InputError: there is no table, or none that is not refused.
  std::vector<log::LogTable> finish() &&;

 private:
  [[nodiscard]] std::vector<Statement> notes() const;

  std::string file_;
  std::vector<log::LogTable> tables_;
  std::vector<Statement> notes_;
  std::vector<Statement> left_out_;
  std::size_t more_left_out_{};
};

}  // namespace tribolog::ingest::measurement
