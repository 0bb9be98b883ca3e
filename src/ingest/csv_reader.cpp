#include "ingest/csv_reader.h"

#include <algorithm>

#include "ingest/closest_match.h"
#include "ingest/csv_header.h"
#include "ingest/csv_lines.h"
#include "ingest/csv_rows.h"

namespace tribolog {
namespace {

RowLayout read_header(RowCursor& cursor, const std::vector<WantedColumn>& columns,
                      CsvTable& table) {
  const Location line{table.file, cursor.line(), 0};
  RowLayout layout;
  layout.header_row = cursor.row();
  layout.header = split_row(cursor.row(), table.delimiter, line);
  if (table.delimiter == Delimiter::spaces) layout.header = join_units(std::move(layout.header));
  check_header(layout.header, line);
  layout.slots.assign(layout.header.size(), -1);
  for (const Field& field : layout.header) table.header.push_back(field.text);
  for (const WantedColumn& wanted : columns) {
    const std::size_t index = find_column(layout.header, wanted.name, wanted.if_missing, line);
    if (layout.slots[index] >= 0) {
      throw InputError({table.file, line.line, static_cast<long>(layout.header[index].column)},
                       {"column " + in_quotes(wanted.name) + " is asked for twice", "", "", ""});
    }
    layout.slots[index] = static_cast<int>(table.columns.size());
    table.columns.push_back({read_header_field(layout.header[index].text), {}, 0});
  }
  return layout;
}

/// Rows to make room for; a guess from the first row's length, bounded by the file's size.
std::size_t likely_rows(std::string_view text, std::size_t bytes_walked) {
  const std::string_view rest = text.substr(bytes_walked);
  const std::size_t first_row = std::min(rest.find('\n'), rest.size()) + 1;
  return rest.size() / std::max<std::size_t>(first_row, 8) + 1;
}

}  // namespace

CsvTable read_csv(std::string_view bytes, const std::string& file,
                  const std::vector<WantedColumn>& columns) {
  const std::string_view text = text_of_log(bytes, file);
  CsvTable table;
  table.file = file;
  table.delimiter = sniff_delimiter(text, file);
  RowCursor cursor(text);
  if (!cursor.next()) throw InputError({file, 0, 0}, {"no header row", "", "", ""});
  const RowLayout layout = read_header(cursor, columns, table);
  for (LogColumn& column : table.columns) {
    column.values.reserve(likely_rows(text, cursor.bytes_walked()));
  }
  if (table.delimiter != Delimiter::comma) {
    table.notes.push_back("columns are separated by " + to_string(table.delimiter));
  }
  read_rows(cursor, layout, table);
  if (cursor.mixed_line_ends()) table.notes.emplace_back("line ends are mixed (LF, CR LF, CR)");
  if (table.rows == 0) {
    throw InputError({file, cursor.line(), 0}, {"no data rows", "", "", ""});
  }
  return table;
}

}  // namespace tribolog
