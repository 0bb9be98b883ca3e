// What stands in front of a log's table: a block of words, as exports of TwinCAT and LabVIEW have
// it, or what a microcontroller says before it writes numbers.

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "ingest/text/csv_rows.h"
#include "ingest/text/fields.h"

namespace tribolog::ingest::text {
namespace {

constexpr std::size_t looked_at_rows = 300;
constexpr std::size_t rows_of_a_table = 5;
constexpr std::size_t fewest_rows_of_a_table = 3;  // of a short log

struct Row {
  std::vector<Field> fields;
  long line{};
};

/// The first rows of a log, each split where it is first looked at: a table mostly begins at once.
class FirstRows {
 public:
  FirstRows(RowCursor cursor, Delimiter delimiter, const std::string& file)
      : cursor_(std::move(cursor)), delimiter_(delimiter), file_(file) {}

  /// Whether there is one in that place.
  bool has(std::size_t place) {
    while (rows_.size() <= place && read_one()) {
    }
    return place < rows_.size();
  }
  /// As far as has() was asked.
  [[nodiscard]] const std::vector<Row>& rows() const { return rows_; }

 private:
  bool read_one() {
    if (rows_.size() == looked_at_rows || !cursor_.next() ||
        cursor_.row().size() > longest_line_bytes) {
      return false;
    }
    Row& row = rows_.emplace_back();
    row.line = cursor_.line();
    try {
      row.fields = split_row(cursor_.row(), delimiter_, {file_, cursor_.line(), 0});
    } catch (const InputError&) {
      // a row without fields is in no table
    }
    return true;
  }

  RowCursor cursor_;
  Delimiter delimiter_;
  const std::string& file_;
  std::vector<Row> rows_;
};

/// But for a delimiter at the end.
std::size_t columns_of(const std::vector<Field>& fields) {
  const bool has_trailing = fields.size() > 1 && fields.back().text.empty();
  return fields.size() - (has_trailing ? 1 : 0);
}

/// Of rows of one table, of which some end with a delimiter or an empty cell.
bool are_alike(const std::vector<Field>& a, const std::vector<Field>& b) {
  return a.size() == b.size() || columns_of(a) == columns_of(b) || a.size() == columns_of(b) ||
         columns_of(a) == b.size();
}

/// The first row of a table of numbers; nothing where there is none.
std::optional<std::size_t> first_of_table(FirstRows& first, DecimalMark mark) {
  std::size_t alike = 0;
  for (std::size_t k = 0; first.has(k); ++k) {
    const std::vector<Field>& fields = first.rows()[k].fields;
    const bool is_of_numbers = fields.size() > 1 && holds_numbers_only(fields, mark);
    const bool goes_on = alike > 0 && are_alike(fields, first.rows()[k - 1].fields);
    alike = !is_of_numbers ? 0 : goes_on ? alike + 1 : 1;
    if (alike < fewest_rows_of_a_table) continue;
    const bool is_end = k + 1 < looked_at_rows && !first.has(k + 1);
    if (alike == rows_of_a_table || is_end) return k + 1 - alike;
  }
  return std::nullopt;
}

bool is_of_words(const std::vector<Field>& fields, DecimalMark mark) {
  return std::all_of(fields.begin(), fields.end(), [&](const Field& field) {
    return field.text.empty() || read_number(field.text, mark).kind == FieldKind::text;
  });
}

bool is_same_word(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](char x, char y) {
    return (x >= 'A' && x <= 'Z' ? x + 32 : x) == (y >= 'A' && y <= 'Z' ? y + 32 : y);
  });
}

/// Of a row that states a property of each channel: its key, in each pair of fields the first.
std::string_view key_of(const std::vector<Field>& fields, std::size_t columns) {
  if (columns < 4 || columns % 2 != 0 || fields.size() + 1 < columns || fields.size() > columns) {
    return "";
  }
  for (std::size_t k = 2; k < fields.size(); k += 2) {
    if (fields[k].text != fields.front().text) return "";
  }
  return fields.front().text;
}

/// "ms" of "SampleTime[ms]".
std::string unit_in(std::string_view key) {
  const std::size_t open = key.find('[');
  const std::size_t close = key.rfind(']');
  const bool has_unit = open != std::string_view::npos && close != std::string_view::npos;
  return has_unit && close > open ? std::string(key.substr(open + 1, close - open - 1)) : "ms";
}

/// Pairs of a time and a value for each channel, whose properties stand in rows above.
void read_channels(const std::vector<Row>& above, std::size_t columns, Preamble& found) {
  std::string time_unit = "ms";
  std::vector<std::string> names(columns / 2);
  std::vector<std::string> units(columns / 2);
  for (const Row& row : above) {
    const std::string_view key = key_of(row.fields, columns);
    const bool is_time = key.starts_with("SampleTime");
    if (is_time) time_unit = unit_in(key);
    std::vector<std::string>* const values = is_same_word(key, "name")   ? &names
                                             : is_same_word(key, "unit") ? &units
                                                                         : nullptr;
    for (std::size_t k = 0; values != nullptr && 2 * k + 1 < row.fields.size(); ++k) {
      (*values)[k] = row.fields[2 * k + 1].text;
    }
  }
  if (std::any_of(names.begin(), names.end(), [](const auto& name) { return name.empty(); })) {
    return;
  }
  for (std::size_t k = 0; k < names.size(); ++k) {
    found.names.push_back({"time [" + time_unit + "]", 1});
    found.names.push_back({units[k].empty() ? names[k] : names[k] + " [" + units[k] + "]", 1});
  }
}

/// LabVIEW's properties of the columns: "Y_Unit_Label" behind the first one, which is the time.
void read_units_of_labview(const std::vector<Row>& above, std::size_t columns, Preamble& found) {
  for (const Row& row : above) {
    if (row.fields.empty() || row.fields.size() < columns) continue;
    const bool is_of_time = row.fields.front().text == "X_Dimension";
    if (!is_of_time && row.fields.front().text != "Y_Unit_Label") continue;
    found.units.resize(columns);
    if (is_of_time) {
      if (row.fields[1].text == "Time") found.units.front() = "s";
      continue;
    }
    for (std::size_t k = 1; k < columns; ++k) found.units[k] = row.fields[k].text;
  }
}

/// The rows of words right above the table, as many as its columns: names, and units below them.
void read_rows_above(const std::vector<Row>& above, std::size_t columns, DecimalMark mark,
                     Preamble& found) {
  std::size_t first = above.size();
  const auto may_be = [&](const Row& row) {
    const std::size_t fields = row.fields.size();
    const auto empty = std::count_if(row.fields.begin(), row.fields.end(),
                                     [](const Field& field) { return field.text.empty(); });
    return (fields == columns || fields == columns + 1) && empty <= 1 &&
           is_of_words(row.fields, mark);
  };
  while (first > 0 && may_be(above[first - 1])) --first;
  if (first == above.size()) return;
  found.names = above[first].fields;
  found.names.resize(columns);  // LabVIEW's last one is of remarks, which no row has
  if (first + 1 < above.size() && holds_units(above[first + 1].fields, mark)) {
    for (std::size_t k = 0; k < columns; ++k) {
      found.units.emplace_back(without_brackets(above[first + 1].fields[k].text));
    }
  }
  if (found.units.empty()) read_units_of_labview(above, columns, found);
}

/// Whether the log is read as it is: the first row names the columns, units may stand below. What
/// is wrong with either is reported there.
bool is_plain(const std::vector<Row>& rows, std::size_t first, DecimalMark mark) {
  if (first == 0) return true;
  const bool is_sentence = rows.front().fields.size() == 1;
  if (first == 1 && !is_sentence) return true;  // names of other columns, or an open quote
  if (!are_alike(rows.front().fields, rows[first].fields)) return false;
  // Cells that are no numbers are reported where they stand.
  const bool has_numbers =
      std::any_of(rows.begin() + 1, rows.begin() + static_cast<std::ptrdiff_t>(first),
                  [&](const Row& row) { return !is_of_words(row.fields, mark); });
  return first == 1 || has_numbers || (first == 2 && are_alike(rows[1].fields, rows[first].fields));
}

}  // namespace

std::optional<Preamble> find_preamble(const RowCursor& start, const std::string& file,
                                      const std::optional<Delimiter>& stated) {
  std::optional<Preamble> best;
  for (const Delimiter delimiter :
       {Delimiter::tab, Delimiter::semicolon, Delimiter::comma, Delimiter::spaces}) {
    if (stated && *stated != delimiter) continue;
    // Without one, no row has two fields.
    const bool is_there = delimiter == Delimiter::spaces ||
                          start.rest().find(static_cast<char>(delimiter)) != std::string_view::npos;
    if (!is_there) continue;
    FirstRows first_rows(start, delimiter, file);
    for (const DecimalMark mark : {DecimalMark::point, DecimalMark::comma}) {
      if (mark == DecimalMark::comma && delimiter == Delimiter::comma) continue;
      const auto first = first_of_table(first_rows, mark);
      if (!first) continue;
      const std::vector<Row>& rows = first_rows.rows();
      if (is_plain(rows, *first, mark)) return std::nullopt;
      if (best && best->line <= rows[*first].line) continue;
      Preamble found;
      found.line = rows[*first].line;
      found.delimiter = delimiter;
      const std::vector<Row> above(rows.begin(),
                                   rows.begin() + static_cast<std::ptrdiff_t>(*first));
      const std::size_t columns = columns_of(rows[*first].fields);
      read_channels(above, columns, found);
      if (found.names.empty()) read_rows_above(above, columns, mark, found);
      best = std::move(found);
    }
  }
  return best;
}

}  // namespace tribolog::ingest::text
