#pragma once
// A log as lines of text.

#include <cstddef>
#include <string>
#include <string_view>

namespace tribolog {

/// Refuses what is not a text of lines and returns it without its byte order mark.
/// @throw InputError: the file is empty, UTF-16, holds a NUL byte, or starts as a known binary
///        format does (gzip, zip, PNG, ELF, MCAP, rosbag, HDF5, Parquet, SQLite, NumPy, MATLAB).
std::string_view text_of_log(std::string_view bytes, const std::string& file);

/// Walks the rows of a text: lines that are neither blank nor comments (`#`). A line ends with LF,
/// CR LF or CR, also mixed.
class RowCursor {
 public:
  explicit RowCursor(std::string_view text) : rest_(text), bytes_(text.size()) {}

  /// Goes to the next row. @return false at the end of the text.
  bool next();

  /// Goes on to `bytes` further on, behind as many whole lines.
  /// @param any_lf, any_cr_lf how they end.
  void pass(std::size_t bytes, std::size_t lines, bool any_lf, bool any_cr_lf);

  /// What is behind the row.
  [[nodiscard]] std::string_view rest() const { return rest_; }
  [[nodiscard]] std::string_view row() const { return row_; }
  [[nodiscard]] long line() const { return line_; }  ///< Of the row; counts from 1.
  [[nodiscard]] bool has_line_end() const { return has_line_end_; }
  [[nodiscard]] std::size_t bytes_walked() const { return bytes_ - rest_.size(); }
  [[nodiscard]] bool is_last() const { return rest_.empty(); }
  /// More than one kind of line end so far.
  [[nodiscard]] bool mixed_line_ends() const { return (kinds_ & (kinds_ - 1)) != 0; }

 private:
  void next_line();

  std::string_view rest_;
  std::string_view row_;
  std::size_t bytes_;
  long line_{0};
  bool has_line_end_{false};
  unsigned kinds_{0};
};

}  // namespace tribolog
