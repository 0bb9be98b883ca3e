#pragma once
// The rows of a log: its header, its data, and what is said of a row that cannot be used.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "base/error.h"
#include "ingest/text/csv_dialect.h"
#include "ingest/text/csv_lines.h"
#include "ingest/text/csv_reader.h"
#include "ingest/text/fields.h"

namespace tribolog::ingest::text {

// The header row of a log.

/// Whether a first row holds numbers and gaps only, a number at least: no header.
bool holds_numbers_only(const std::vector<Field>& row, DecimalMark mark);

/// Whether one of a row's fields is a number with a decimal mark: no column is called so.
bool holds_a_fraction(const std::vector<Field>& row, DecimalMark mark);

/// "#1", "#2" and so on, for a log without header.
std::vector<Field> names_by_position(std::size_t columns);

/// The names in a comment, without its mark: "# t q tau" as NumPy's savetxt writes it. Of words
/// with blanks between them that may be a sentence nothing is taken for names.
/// @param columns of the row below it. @return nothing where they are not as many, or no names.
std::optional<std::vector<Field>> names_in_comment(std::string_view comment, std::size_t columns,
                                                   Delimiter delimiter, const Location& line);

/// Rows of sensor_msgs/JointState as `ros2 topic echo --csv` writes them, without a header: sec,
/// nanosec and frame_id; the joints' names; then position, velocity and effort, each a number for
/// each joint or, where the message has none, a single empty cell.
class EchoedJointStates {
 public:
  /// @param rows the first ones of a log. @return nothing for other rows. The joints are
  /// those that most rows have.
  static std::optional<EchoedJointStates> in(const std::vector<std::vector<Field>>& rows);
  /// Whether the first row may be one; if not, in() finds none.
  static bool may_begin_with(const std::vector<Field>& row);

  /// "sec", "nanosec", "frame_id", "name_0" and so on, then "NAME.position", "NAME.velocity" and
  /// "NAME.effort"; or else, where all rows lack cells and do not show of which array, "#7" and so
  /// on.
  [[nodiscard]] std::vector<Field> header() const;
  /// Gives a row the header's columns: gaps for an array that the message does not have.
  /// @return false for a row of other joints, and one that lacks cells and does not show which.
  [[nodiscard]] bool lay_out(std::vector<Field>& row) const;

 private:
  std::vector<std::string> joints_;
  std::optional<std::size_t> unknown_numbers_;  ///< In a row, where their names are not known.
};

/// Lines of words in front of a table of numbers.
struct Preamble {
  long line{};  ///< On which the table's numbers begin.
  Delimiter delimiter{Delimiter::comma};
  std::vector<Field> names;        ///< Of its columns; empty: none were found.
  std::vector<std::string> units;  ///< From a row below the names; empty: none.
};

/// What has to be passed to come to the table: its columns' names are those of the row of words
/// right above it, or of TwinCAT's properties of channels, each a time and a value.
/// @param start in front of the log. @param stated its delimiter.
/// @return nothing where the first row names the columns, or no table of numbers was found.
std::optional<Preamble> find_preamble(const RowCursor& start, const std::string& file,
                                      const std::optional<Delimiter>& stated);

/// "Nm" of "[Nm]" and "(Nm)".
std::string_view without_brackets(std::string_view unit);

/// Whether a row under the header states units: most of its fields are known ones, none a number.
bool holds_units(const std::vector<Field>& row, DecimalMark mark);

/// @throw InputError at the first byte that is not UTF-8.
void refuse_other_encodings(const std::vector<Field>& header, const Location& line);

/// Those that stand more than once.
std::vector<std::string> repeated_names(const std::vector<Field>& header);

/// The columns of a header by their names.
class ColumnNames {
 public:
  /// @param header outlives the names.
  explicit ColumnNames(const std::vector<Field>& header);

  /// Whether a column has this name, with or without its unit.
  [[nodiscard]] bool has(const std::string& name) const;
  /// Whether it has, or this is the position of one, "#2".
  [[nodiscard]] bool has_or_counts(const std::string& name) const;
  /// Index of the column with this name; the full text counts first, then the name without its
  /// unit, then, of "#2", the position.
  /// @throw InputError if there is none (listing those that are, and the closest) or several, also
  ///        of the same name.
  [[nodiscard]] std::size_t find(const std::string& name, const std::string& hint_if_missing,
                                 const Location& line) const;

 private:
  struct Places {
    std::size_t first{};
    std::size_t count{};
  };
  using Index = std::unordered_map<std::string, Places>;
  static void add(const std::string& name, std::size_t place, Index& index);

  const std::vector<Field>& header_;
  Index by_text_;       ///< With the unit.
  Index by_bare_name_;  ///< Without.
};

/// Under blanks as delimiter "tau [Nm]" falls into two fields; joins them again.
std::vector<Field> join_units(std::vector<Field> header);

// The data rows of a log, once delimiter and header are known.

/// What the rows are read against.
struct RowLayout {
  std::vector<Field> header;
  std::string header_row;  ///< As it stands in the file; empty: there is none.
  std::vector<int> slots;  ///< For each column of the file: index in `columns`, or -1.
  std::vector<log::ColumnReading> readings;  ///< Of each of `columns`.
  std::optional<EchoedJointStates> joint_states;
  DecimalMark mark{DecimalMark::point};
  bool skip_bad_rows{};  ///< Leaves out and counts what is refused otherwise.
};

/// Reads every row that the cursor has not passed yet into the table's columns.
/// @throw InputError at the first field or row that cannot be used; where those are skipped, if
///        there are too many.
void read_rows(RowCursor& cursor, const RowLayout& layout, CsvTable& table);

// What is said of a row that cannot be used: what stands where, the likely cause, the way out.

struct RefusedRow {
  const CsvTable& table;  ///< As far as it is read.
  const RowLayout& layout;
  long line{};
  std::string_view text{};    ///< The row,
  std::string_view behind{};  ///< and what follows it, as far as it is in memory.
};

/// @param rows from the first data row on, as far as they are in memory.
/// @param names columns of the header.
/// @throw InputError where all cells are whole numbers and the first row has more of them than
///        names: decimal commas are cut by commas between the columns. The hint says what to export
///        instead, and how to mend a log in which all numbers have a fraction.
void refuse_commas_between_commas(std::string_view rows, std::size_t names, const Location& first);

/// @throw InputError: the row is the header once more.
[[noreturn]] void refuse_second_header(const RefusedRow& row);

/// @param found number of fields.
/// @throw InputError: it is not the header's; as refuse_commas_between_commas() for a first row.
[[noreturn]] void refuse_ragged_row(const RefusedRow& row, std::size_t found);

/// @param column index of the field in the file.
/// @throw InputError: the field is no number, or a number too large.
[[noreturn]] void refuse_field(const RefusedRow& row, const Field& field, std::size_t column,
                               FieldKind kind);

}  // namespace tribolog::ingest::text
