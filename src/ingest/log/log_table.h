#pragma once
// What a reader makes of a log, whatever its format: columns of numbers that share their rows.

#include <algorithm>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "base/statement.h"

namespace tribolog::ingest::log {

/// A column's name and unit: "tau [Nm]" and "tau (Nm)" are "tau" in "Nm".
struct ColumnHeader {
  std::string full;
  std::string name;
  std::string unit;     ///< Empty: none stated.
  std::size_t place{};  ///< Of the column in a text file, from 1; 0: not of one.
};

struct LogTable;

/// What a column's fields are.
enum class ColumnReading {
  number,
  clock,        ///< A number whose differences count: exact to the nanosecond.
  iso_time,     ///< ISO 8601, read as seconds.
  time_of_day,  ///< "08:15:00.25", read as seconds; behind midnight it goes on.
  date,         ///< "2026-03-01", read as seconds.
  words,        ///< Any text, read as its place among LogColumn::words.
};

struct LogColumn {
  ColumnHeader header;
  std::vector<double> values;  ///< NaN where there is a gap.
  /// Taken off every value: of a clock that counts from 1970 the whole units of its first reading,
  /// without which no double holds nanoseconds. 0 otherwise.
  double origin{};
  std::size_t gaps{};
  ColumnReading reading{ColumnReading::number};
  std::vector<std::string> words{};  ///< Of such a column: what its values 0, 1, 2 ... stand for.
  /// Rows, ascending, whose number no joint has: made gaps of, as the manifest allows.
  std::vector<std::size_t> impossible{};
  [[nodiscard]] bool is_impossible(std::size_t row) const {
    return std::binary_search(impossible.begin(), impossible.end(), row);
  }
  /// File and lines of its rows, without columns, where they are not the table's own; null: they
  /// are.
  std::shared_ptr<const LogTable> stands_in{};
};

/// What stands in a column, of numbers "1" and the like: for those that name joints.
LogColumn as_words(LogColumn column);

struct LogTable {
  std::string file;   ///< As given, for messages.
  std::string group;  ///< Topic or variable whose rows these are; empty: the only one.
  std::vector<std::string> header;  ///< All columns, in full, also those that were not read.
  std::vector<LogColumn> columns;   ///< Those read.
  std::size_t rows{};               ///< Of each column.
  std::size_t cut_rows{};           ///< Those left out because the file ends inside them.
  std::size_t remark_rows{};        ///< Lines of words among them, which are no rows.
  std::size_t bad_rows{};           ///< Those left out because they cannot be used, as stated.
  /// Those left out of ros2 topic echo --csv: other joints', or nothing tells what their numbers
  /// are.
  std::size_t unclear_rows{};
  std::size_t other_rows{};      ///< Those left out because they are another joint's, as stated,
  std::size_t rows_of_others{};  ///< or another recording's of the same log.
  std::vector<Statement> notes;  ///< Peculiarities that the user should know.
  /// Not empty: something in the table is damaged, and what. Only the rows before it stand here,
  /// and take_columns() refuses them; other tables of the log are not concerned.
  std::string refusal;

  /// Line of the file on which a row (from 0) stands; 0 where the file has no lines.
  [[nodiscard]] long line_of(std::size_t row) const;
  /// (row, line) wherever a row does not follow directly on the line before it; ascending.
  std::vector<std::pair<std::size_t, long>> line_breaks;
};

/// The same table with these of its rows, ascending; the others count in `other_rows`.
LogTable with_rows(const LogTable& table, const std::vector<std::size_t>& rows);

/// The values of these rows, and their gaps.
LogColumn with_rows(const LogColumn& column, const std::vector<std::size_t>& rows);

/// Of a column of words the rows in which the one at this place stands.
std::vector<std::size_t> rows_that_say(const LogColumn& column, std::size_t word);

/// Leaves the rows alone in which a column of words has the one at this place; the others count in
/// `other_rows`.
/// @param named_by of the table's rows, but none of its columns.
void keep_rows_of(const LogColumn& named_by, std::size_t word, LogTable& table);

/// From this reading on a clock is taken to count from 1970 in whatever unit: no joint is recorded
/// for three years.
inline constexpr double counts_from_1970 = 1e8;

/// A column to convert.
struct WantedColumn {
  /// With or without its bracketed unit; "#2" is the second one, whatever its name.
  std::string name;
  std::string if_missing{};  ///< Added to the hint where there is no such column.
  ColumnReading reading{ColumnReading::number};
  bool is_optional{};  ///< Not refused where there is no such column, but left out.
  friend bool operator==(const WantedColumn&, const WantedColumn&) = default;
};

}  // namespace tribolog::ingest::log
