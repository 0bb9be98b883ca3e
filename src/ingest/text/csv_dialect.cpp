#include "ingest/text/csv_dialect.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "base/closest_match.h"
#include "ingest/text/csv_lines.h"
#include "ingest/text/csv_rows.h"
#include "ingest/text/fields.h"

namespace tribolog::ingest::text {

namespace {

class RowSplitter {
 public:
  RowSplitter(std::string_view row, Delimiter delimiter, const Location& line)
      : row_(row), delimiter_(delimiter), line_(line) {}

  std::vector<Field> split() {
    const bool by_spaces = delimiter_ == Delimiter::spaces;
    for (skip_blanks(); !(by_spaces && at_end()); skip_blanks()) {
      fields_.push_back(next_field());
      if (fields_.size() > most_columns) {
        fail({line_.file, line_.line, 0},
             {"more than " + std::to_string(most_columns) + " columns", "", "", ""});
      }
      skip_blanks();
      if (at_end()) break;
      if (!by_spaces) ++i_;  // the delimiter
      if (!by_spaces && at_end()) {
        fields_.push_back({"", i_ + 1});
        break;
      }
    }
    return std::move(fields_);
  }

 private:
  [[noreturn]] static void fail(const Location& where, const InputError::Problem& problem) {
    throw InputError(where, problem);
  }
  [[nodiscard]] bool at_end() const { return i_ >= row_.size(); }
  [[nodiscard]] bool at_delimiter() const {
    return delimiter_ == Delimiter::spaces ? row_[i_] == ' ' || row_[i_] == '\t'
                                           : row_[i_] == static_cast<char>(delimiter_);
  }
  [[nodiscard]] Location at(std::size_t i) const {
    return {line_.file, line_.line, static_cast<long>(i + 1)};
  }
  void skip_blanks() {
    while (!at_end() && (row_[i_] == ' ' || row_[i_] == '\t') &&
           (delimiter_ == Delimiter::spaces || !at_delimiter())) {
      ++i_;
    }
  }

  Field next_field() {
    const std::size_t start = i_;
    if (!at_end() && row_[i_] == '"') return quoted_field();
    while (!at_end() && !at_delimiter()) ++i_;
    check_length(start, i_ - start);
    return {std::string(trimmed(row_.substr(start, i_ - start))), start + 1};
  }

  Field quoted_field() {
    const std::size_t start = i_++;
    std::string text;
    for (;; ++i_) {
      if (at_end()) {
        fail(at(start), {"quote is not closed in its line", "", "",
                         "a line end within quotes is not supported"});
      }
      if (row_[i_] == '"' && (i_ + 1 >= row_.size() || row_[i_ + 1] != '"')) break;
      if (row_[i_] == '"') ++i_;
      text += row_[i_];
    }
    ++i_;
    check_length(start, text.size());
    skip_blanks_within();
    if (!at_end() && !at_delimiter()) {
      fail(at(i_), {"text after a closing quote", in_quotes(row_.substr(i_, 20)),
                    "a delimiter or the end of the line", ""});
    }
    return {std::string(trimmed(text)), start + 1};
  }
  void skip_blanks_within() {
    if (delimiter_ != Delimiter::spaces) skip_blanks();
  }

  void check_length(std::size_t start, std::size_t bytes) const {
    if (bytes <= longest_field_bytes) return;
    fail(at(start), {"field is longer than 64 KiB", std::to_string(bytes) + " bytes", "", ""});
  }

  std::string_view row_;
  Delimiter delimiter_;
  const Location& line_;
  std::size_t i_{0};
  std::vector<Field> fields_;
};

}  // namespace

std::vector<Field> split_row(std::string_view row, Delimiter delimiter, const Location& line) {
  return RowSplitter(row, delimiter, line).split();
}

namespace {

/// Number of columns that a row has under a delimiter; quotes are respected, broken ones ignored.
std::size_t count_columns(std::string_view row, Delimiter delimiter) {
  std::size_t columns = 0;
  bool in_field = false;
  bool within_quotes = false;
  for (const char c : row) {
    if (c == '"') within_quotes = !within_quotes;
    if (delimiter == Delimiter::spaces) {
      const bool blank = !within_quotes && (c == ' ' || c == '\t');
      if (!blank && !in_field) ++columns;
      in_field = !blank;
    } else if (!within_quotes && c == static_cast<char>(delimiter)) {
      ++columns;
    }
  }
  return delimiter == Delimiter::spaces ? columns : columns + 1;
}

struct Fit {
  Delimiter delimiter{};
  std::size_t columns{};     ///< Of the header.
  std::size_t rows_alike{};  ///< Sampled rows with as many; one trailing delimiter is forgiven.
};

Fit fit_of(Delimiter delimiter, const std::vector<std::string_view>& rows) {
  Fit fit{delimiter, count_columns(rows.front(), delimiter), 0};
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const std::size_t columns = count_columns(rows[i], delimiter);
    const bool has_trailing = trimmed(rows[i]).ends_with(static_cast<char>(delimiter));
    if (columns == fit.columns || (has_trailing && columns == fit.columns + 1)) ++fit.rows_alike;
  }
  return fit;
}

}  // namespace

std::string to_string(Delimiter delimiter) {
  switch (delimiter) {
    case Delimiter::comma:
      return "commas";
    case Delimiter::semicolon:
      return "semicolons";
    case Delimiter::tab:
      return "tabs";
    case Delimiter::spaces:
      return "spaces";
  }
  return "unknown";
}

Delimiter sniff_delimiter(std::string_view text, const std::string& file, DecimalMark mark) {
  return sniff_delimiter(RowCursor(text), file, mark);
}

Delimiter sniff_delimiter(RowCursor cursor, const std::string& file, DecimalMark mark) {
  constexpr std::size_t sampled_rows = 20;
  std::vector<std::string_view> rows;
  long header_line = 0;
  while (rows.size() < sampled_rows && cursor.next()) {
    if (rows.empty()) header_line = cursor.line();
    rows.push_back(cursor.row());
  }
  if (rows.empty()) return Delimiter::comma;
  std::vector<Fit> fits;
  for (const Delimiter d : {Delimiter::comma, Delimiter::semicolon, Delimiter::tab}) {
    if (d == Delimiter::comma && mark == DecimalMark::comma) continue;
    if (const Fit fit = fit_of(d, rows); fit.columns > 1) fits.push_back(fit);
  }
  if (fits.empty()) {
    const Fit spaces = fit_of(Delimiter::spaces, rows);
    const bool is_one_name = rows.size() > 1 && spaces.rows_alike == 0 && spaces.columns == 2 &&
                             count_columns(rows[1], Delimiter::spaces) == 1;  // "tau [Nm]"
    const Delimiter alone = mark == DecimalMark::comma ? Delimiter::semicolon : Delimiter::comma;
    return spaces.columns > 1 && !is_one_name ? Delimiter::spaces : alone;
  }
  std::stable_sort(fits.begin(), fits.end(), [](const Fit& a, const Fit& b) {
    return a.rows_alike != b.rows_alike ? a.rows_alike > b.rows_alike : a.columns > b.columns;
  });
  if (fits.size() > 1 && fits[1].rows_alike == fits[0].rows_alike && fits[0].rows_alike > 0) {
    throw InputError(
        {file, header_line, 0},
        {"it is not clear what separates the columns", "",
         to_string(fits[0].delimiter) + " or " + to_string(fits[1].delimiter),
         "state it: [log] delimiter = \"comma\", \"semicolon\", \"tab\" or \"spaces\""});
  }
  return fits[0].delimiter;
}

std::optional<Delimiter> take_stated_delimiter(RowCursor& cursor) {
  RowCursor first = cursor;
  if (!first.next()) return std::nullopt;
  std::string_view row = trimmed(first.row());
  if (row.size() > 2 && row.front() == '"' && row.back() == '"')
    row = row.substr(1, row.size() - 2);
  constexpr std::string_view statement = "sep=";
  if (row.size() != statement.size() + 1 && row != "sep=") return std::nullopt;
  if (!row.starts_with(statement) && !row.starts_with("SEP=")) return std::nullopt;
  // A tab behind the sign is no blank around the line.
  const std::size_t at = first.row().find('=') + 1;
  const char mark = at < first.row().size() ? first.row()[at] : '\0';
  for (const Delimiter known :
       {Delimiter::comma, Delimiter::semicolon, Delimiter::tab, Delimiter::spaces}) {
    if (mark != static_cast<char>(known)) continue;
    cursor = first;
    return known;
  }
  return std::nullopt;
}

bool show_decimal_commas(RowCursor cursor, const std::string& file, const TextLogRules& rules) {
  constexpr std::size_t looked_at_rows = 200;
  if (rules.header_line) cursor.go_to_line(*rules.header_line, file);
  const auto stated = rules.header_line ? std::nullopt : take_stated_delimiter(cursor);
  Delimiter delimiter{};
  const auto preamble =
      rules.header_line ? std::nullopt
                        : find_preamble(cursor, file, rules.delimiter ? rules.delimiter : stated);
  if (preamble) cursor.go_to_line(preamble->line, file);
  try {
    delimiter = rules.delimiter ? *rules.delimiter
                : stated        ? *stated
                : preamble      ? preamble->delimiter
                                : sniff_delimiter(cursor, file, DecimalMark::comma);
  } catch (const InputError&) {
    return false;
  }
  bool is_shown = false;
  std::size_t columns = 0;
  for (std::size_t row = 0; row < looked_at_rows && cursor.next() && cursor.has_line_end(); ++row) {
    std::vector<Field> fields;
    try {
      fields = split_row(cursor.row(), delimiter, {file, cursor.line(), 0});
    } catch (const InputError&) {
      return false;
    }
    if (!fields.empty() && fields.back().text.empty()) fields.pop_back();
    if (delimiter == Delimiter::comma || fields.size() < 2) return false;
    const bool is_header =
        row == 0 && read_number(fields[0].text, DecimalMark::comma).kind == FieldKind::text;
    if (is_header && cursor.row().find(',') != std::string_view::npos) return false;
    if (row > 1 && fields.size() != columns) return false;
    columns = fields.size();
    for (const Field& field : fields) {
      const bool has_point = field.text.find('.') != std::string::npos;
      if (has_point && read_number(field.text).kind == FieldKind::number) return false;
      const bool has_zero = field.text.starts_with("0,") || field.text.starts_with("-0,");
      is_shown = is_shown || (looks_like_decimal_comma(field.text) &&
                              (has_zero || !looks_like_thousands(field.text)));
    }
  }
  return is_shown;
}

log::ColumnHeader read_header_field(const std::string& field) {
  log::ColumnHeader header{field, field, ""};
  const char close = field.empty() ? '\0' : field.back();
  if (close != ']' && close != ')') return header;
  const std::size_t open = field.rfind(close == ']' ? '[' : '(');
  if (open == std::string::npos || open == 0) return header;
  header.name = trimmed(std::string_view(field).substr(0, open));
  header.unit = trimmed(std::string_view(field).substr(open + 1, field.size() - open - 2));
  return header;
}

}  // namespace tribolog::ingest::text
