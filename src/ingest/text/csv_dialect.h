#pragma once
// How a log separates its columns, and what its header says.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "ingest/log/log_table.h"
#include "ingest/text/csv_lines.h"
#include "ingest/text/fields.h"

namespace tribolog::ingest::text {

enum class Delimiter : char { comma = ',', semicolon = ';', tab = '\t', spaces = ' ' };

struct Field {
  std::string text;      ///< Without quotes and without blanks around it.
  std::size_t column{};  ///< Of its first byte in the line; counts from 1.
};

inline constexpr std::size_t longest_field_bytes = 64 * 1024;
inline constexpr std::size_t most_columns = 65'536;

/// Splits a row. Quoted fields may hold delimiters and "" for a quote. With spaces as delimiter any
/// number of blanks counts as one.
/// @throw InputError at the opening quote of a field that does not end in its line, at a field
///        longer than 64 KiB, or for more than 65536 columns.
std::vector<Field> split_row(std::string_view row, Delimiter delimiter, const Location& line);

// How a text log is to be read where it cannot tell itself: what the manifest's [log] says.

/// Of the columns' names; numbers are ASCII in both.
enum class TextEncoding { utf8, latin1 };

struct TextLogRules {
  DecimalMark decimal_mark{DecimalMark::point};
  std::optional<Delimiter> delimiter;  ///< Absent: found out.
  TextEncoding encoding{TextEncoding::utf8};
  /// Line of the columns' names, or of the first row where there are none; counts from 1. What
  /// stands in front of it is not read. Absent: the first line that is no comment.
  std::optional<long> header_line;
  /// Rows that cannot be used are left out and counted, up to `most_bad_rows` of all.
  bool skip_bad_rows{};
};

/// Share of the rows. A log with more is damaged, or not what the manifest says.
inline constexpr double most_bad_rows = 0.01;

/// "commas", "semicolons", "tabs", "spaces"
std::string to_string(Delimiter delimiter);

/// The delimiter under which the header and the first rows have the same number of columns.
/// @param mark with a decimal comma, commas do not delimit.
/// @throw InputError if two delimiters fit equally well.
Delimiter sniff_delimiter(std::string_view text, const std::string& file,
                          DecimalMark mark = DecimalMark::point);
/// The same from the header on, in front of which the cursor stands.
Delimiter sniff_delimiter(RowCursor cursor, const std::string& file, DecimalMark mark);

/// Passes a first line such as "sep=;", in which a log states its delimiter for Excel.
/// @return that; nothing where the line states none, or an unknown one.
std::optional<Delimiter> take_stated_delimiter(RowCursor& cursor);

/// Whether numbers in the first rows have decimal commas and cannot be read otherwise: no commas
/// between the columns, no point in any number, and one at least that has not just three digits
/// behind its comma, as thousands have.
bool show_decimal_commas(RowCursor cursor, const std::string& file, const TextLogRules& rules);

/// The name and the unit in brackets behind it.
log::ColumnHeader read_header_field(const std::string& field);

}  // namespace tribolog::ingest::text
