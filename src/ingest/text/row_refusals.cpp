#include <algorithm>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "base/closest_match.h"
#include "ingest/log/units.h"
#include "ingest/text/csv_rows.h"
#include "ingest/text/fields.h"

namespace tribolog::ingest::text {
namespace {

/// Where rows before it could be used. Empty where they are skipped already.
std::string way_out(const RefusedRow& row) {
  if (row.layout.skip_bad_rows || row.table.rows == 0) return "";
  return "damaged rows? [log] skip_bad_rows = true (--skip-bad-rows) leaves them out, up to 1 % of "
         "all";
}

std::string joined(const std::string& cause, const std::string& way) {
  return cause + (cause.empty() || way.empty() ? "" : "; ") + way;
}

std::string expected_of(log::ColumnReading reading, DecimalMark mark) {
  if (reading == log::ColumnReading::iso_time) return "a time such as 2026-03-01T08:15:00.25Z";
  if (reading == log::ColumnReading::time_of_day) return "a time such as 08:15:00.25";
  if (reading == log::ColumnReading::date) return "a date such as 2026-03-01";
  return mark == DecimalMark::comma ? "a number with a decimal comma" : "a number";
}

std::string likely_cause(const RefusedRow& row, const std::string& field,
                         log::ColumnReading reading) {
  const DecimalMark mark = row.layout.mark;
  if (mark == DecimalMark::point && looks_like_decimal_comma(field)) {
    return "decimal comma? state it: [log] decimal_comma = true, --decimal-comma of inspect and "
           "init";
  }
  const bool has_point_first = field.find('.') < field.find(',') && field.find(',') != field.npos;
  if (mark == DecimalMark::point && has_point_first &&
      looks_like_thousands(field, DecimalMark::comma)) {
    return "thousands points and a decimal comma? write numbers without the points, and state the "
           "comma: [log] decimal_comma = true, --decimal-comma of inspect and init";
  }
  if (looks_like_thousands(field, mark)) return "thousands separators? write numbers without";
  for (const log::ColumnReading time :
       {log::ColumnReading::iso_time, log::ColumnReading::time_of_day, log::ColumnReading::date}) {
    if (reading == time || !read_time(field, time)) continue;
    return fmt::format("date and time? state unit = \"{}\"", log::unit_of_time(time));
  }
  return row.table.rows == 0 ? "a row of units under the header? put '#' in front of it" : "";
}

/// Cells of a row between commas that are all whole numbers, as numbers with decimal commas leave
/// them; 0 for any other row.
std::size_t whole_numbers_in(std::string_view row) {
  constexpr std::string_view digits = "0123456789";
  std::size_t count = 0;
  for (std::size_t at = 0; at <= row.size(); ++count) {
    const std::size_t end = std::min(row.find(',', at), row.size());
    std::string_view cell = trimmed(row.substr(at, end - at));
    if (cell.starts_with('-') || cell.starts_with('+')) cell.remove_prefix(1);
    if (cell.empty() || cell.find_first_not_of(digits) != std::string_view::npos) return 0;
    at = end + 1;
  }
  return count;
}

}  // namespace

void refuse_commas_between_commas(std::string_view rows, std::size_t names, const Location& first) {
  constexpr std::size_t looked_at_rows = 200;
  RowCursor cursor(rows);
  std::size_t cells_of_first = 0;
  bool are_all_cut = true;
  for (std::size_t row = 0; row < looked_at_rows && cursor.next(); ++row) {
    if (row > 0 && !cursor.has_line_end()) break;
    const std::size_t cells = whole_numbers_in(cursor.row());
    if (cells < names) return;
    if (row == 0) cells_of_first = cells;
    are_all_cut = are_all_cut && cells == 2 * names;
  }
  if (cells_of_first <= names) return;
  const std::string mend =
      are_all_cut ? fmt::format(
                        "; in every row that was looked at each number is cut in two, which "
                        "can be mended: sed -E '{},$ s/([0-9]+),([0-9]+)/\\1.\\2/g' LOG "
                        ">POINTS.csv",
                        first.line)
                  : "; numbers without a fraction have no comma, so that the cells cannot be put "
                    "together again";
  throw InputError(first, {"numbers with decimal commas between columns that commas separate",
                           fmt::format("{} cells for {} names", cells_of_first, names),
                           "semicolons or tabs between the columns, or numbers with a point",
                           "export it so (Excel: list separator \";\"; pandas: to_csv(..., "
                           "decimal='.'))" +
                               mend});
}

void refuse_second_header(const RefusedRow& row) {
  throw InputError({row.table.file, row.line, 1},
                   {"the header stands here again", "", "",
                    joined("two logs concatenated? split the file", way_out(row))});
}

void refuse_ragged_row(const RefusedRow& row, std::size_t found) {
  const std::size_t expected = row.layout.slots.size();
  const bool is_first = row.table.rows == 0 && !row.layout.skip_bad_rows;
  if (row.table.rows == 0 && row.table.delimiter == Delimiter::comma && found > expected) {
    const auto between = static_cast<std::size_t>(row.behind.data() - row.text.data());
    const std::string_view rows =
        row.behind.empty() ? row.text
                           : std::string_view(row.text.data(), between + row.behind.size());
    refuse_commas_between_commas(rows, expected, {row.table.file, row.line, 0});
  }
  const bool comma_suspect = found > expected && row.table.delimiter == Delimiter::comma;
  throw InputError(
      {row.table.file, row.line, 0},
      {"row has another number of fields than the header", fmt::format("{}", found),
       fmt::format("{}", expected),
       joined(comma_suspect ? "decimal or thousands commas? write numbers with a point"
              : is_first    ? "lines in front of the header? [log] header_line (--header-line) "
                              "states the line of the columns' names"
                            : "",
              way_out(row))});
}

void refuse_field(const RefusedRow& row, const Field& field, std::size_t column, FieldKind kind) {
  const Location where{row.table.file, row.line, static_cast<long>(field.column)};
  const std::string what = "column " + in_quotes(row.layout.header[column].text);
  if (kind == FieldKind::overflow) {
    throw InputError(where,
                     {what + ": number is too large", in_quotes(field.text), "", way_out(row)});
  }
  const log::ColumnReading reading =
      row.layout.readings[static_cast<std::size_t>(row.layout.slots[column])];
  const std::string cause = likely_cause(row, field.text, reading);
  throw InputError(where, {what, in_quotes(field.text), expected_of(reading, row.layout.mark),
                           cause.empty() ? way_out(row) : cause});
}

}  // namespace tribolog::ingest::text
