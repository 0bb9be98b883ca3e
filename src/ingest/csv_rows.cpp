#include "ingest/csv_rows.h"

#include <charconv>
#include <cmath>
#include <cstring>
#include <utility>

#include <fmt/format.h>

#include "ingest/closest_match.h"
#include "ingest/number_field.h"

namespace tribolog {
namespace {

class RowReader {
 public:
  RowReader(RowCursor& cursor, const RowLayout& layout, CsvTable& table)
      : cursor_(cursor),
        layout_(layout),
        table_(table),
        delimiter_(static_cast<char>(table.delimiter)),
        values_(table.columns.size()) {}

  void read_all() {
    long expected_line = -1;
    while (cursor_.next()) {
      if (!read_plain_row() && !read_any_row()) {
        note_cut_row();
        return;
      }
      if (cursor_.line() != expected_line) {
        table_.line_breaks.emplace_back(table_.rows, cursor_.line());
      }
      expected_line = cursor_.line() + 1;
      keep();
    }
  }

 private:
  /// The common case at full speed: delimiter is no blank, no quotes, nothing but numbers and gaps.
  /// @return false for every row that needs a closer look.
  bool read_plain_row() {
    if (delimiter_ == ' ') return false;
    const std::string_view row = cursor_.row();
    if (std::memchr(row.data(), '"', row.size()) != nullptr) return false;
    const char* p = row.data();
    const char* const end = p + row.size();
    const std::size_t columns = layout_.slots.size();
    for (std::size_t i = 0; i < columns; ++i) {
      if (layout_.slots[i] < 0) {
        p = end_of_field(p, end);
      } else {
        double& value = values_[static_cast<std::size_t>(layout_.slots[i])];
        const auto read = std::from_chars(p, end, value);
        if (read.ec == std::errc() && (read.ptr == end || *read.ptr == delimiter_) &&
            std::isfinite(value)) {
          p = read.ptr;
        } else {
          const char* const field_end = end_of_field(p, end);
          const NumberField field =
              read_number(std::string_view(p, static_cast<std::size_t>(field_end - p)));
          if (field.kind != FieldKind::number && field.kind != FieldKind::gap) return false;
          value = field.value;
          p = field_end;
        }
      }
      if (p == end) return i + 1 == columns && cursor_.has_line_end();
      ++p;
    }
    return false;
  }

  [[nodiscard]] const char* end_of_field(const char* p, const char* end) const {
    while (p != end && *p != delimiter_) ++p;
    return p;
  }

  /// Any row. @return false for a last row that is cut off. @throw InputError
  bool read_any_row() {
    const Location line{table_.file, cursor_.line(), 0};
    const bool may_be_cut = cursor_.is_last() && !cursor_.has_line_end();
    std::vector<Field> fields;
    try {
      fields = split_row(cursor_.row(), table_.delimiter, line);
    } catch (const InputError&) {
      if (may_be_cut && table_.rows > 0) return false;
      throw;
    }
    const std::size_t columns = layout_.slots.size();
    if (fields.size() == columns + 1 && fields.back().text.empty()) {
      fields.pop_back();
      note_once(has_trailing_delimiter_, "rows end with a delimiter; the empty column is ignored");
    } else if (fields.size() + 1 == columns && layout_.header.back().text.empty()) {
      fields.push_back({"", cursor_.row().size() + 1});
    }
    refuse_second_header();
    const bool ends_with_delimiter =
        fields.back().text.empty() && !layout_.header.back().text.empty();
    if (may_be_cut && (fields.size() < columns || ends_with_delimiter)) return false;
    if (fields.size() != columns) refuse_ragged_row(fields.size());
    for (std::size_t i = 0; i < columns; ++i) {
      if (layout_.slots[i] < 0) continue;
      const NumberField number = read_number(fields[i].text);
      if (number.kind == FieldKind::text || number.kind == FieldKind::overflow) {
        if (may_be_cut && i + 1 == columns && looks_like_cut_number(fields[i].text)) return false;
        refuse_field(fields[i], i, number.kind);
      }
      values_[static_cast<std::size_t>(layout_.slots[i])] = number.value;
    }
    return true;
  }

  void keep() {
    for (std::size_t k = 0; k < values_.size(); ++k) {
      LogColumn& column = table_.columns[k];
      column.values.push_back(values_[k]);
      if (std::isnan(values_[k])) ++column.gaps;
    }
    ++table_.rows;
  }

  void note_once(bool& done, const std::string& note) {
    if (!std::exchange(done, true)) table_.notes.push_back(note);
  }

  void note_cut_row() {
    ++table_.cut_rows;
    table_.notes.push_back(
        fmt::format("file ends inside a row at byte {} (log truncated?); the row is left out",
                    cursor_.bytes_walked()));
  }

  void refuse_second_header() const {
    if (trimmed(cursor_.row()) != trimmed(layout_.header_row)) return;
    throw InputError({table_.file, cursor_.line(), 1},
                     {"the header stands here again", "", "", "two logs concatenated?"});
  }

  [[noreturn]] void refuse_ragged_row(std::size_t found) const {
    const std::size_t expected = layout_.slots.size();
    const bool comma_suspect = found > expected && table_.delimiter == Delimiter::comma;
    throw InputError(
        {table_.file, cursor_.line(), 0},
        {"row has another number of fields than the header", fmt::format("{}", found),
         fmt::format("{}", expected),
         comma_suspect ? "decimal or thousands commas? write numbers with a point" : ""});
  }

  [[noreturn]] void refuse_field(const Field& field, std::size_t column, FieldKind kind) const {
    const std::string name = in_quotes(layout_.header[column].text);
    std::string hint;
    if (kind == FieldKind::overflow) {
      throw InputError({table_.file, cursor_.line(), static_cast<long>(field.column)},
                       {"column " + name + ": number is too large", in_quotes(field.text), "", ""});
    }
    if (looks_like_decimal_comma(field.text)) {
      hint = "decimal comma? write numbers with a point";
    } else if (table_.rows == 0) {
      hint = "a row of units under the header? put '#' in front of it";
    }
    throw InputError({table_.file, cursor_.line(), static_cast<long>(field.column)},
                     {"column " + name, in_quotes(field.text), "a number", hint});
  }

  RowCursor& cursor_;
  const RowLayout& layout_;
  CsvTable& table_;
  char delimiter_;
  std::vector<double> values_;
  bool has_trailing_delimiter_{false};
};

}  // namespace

void read_rows(RowCursor& cursor, const RowLayout& layout, CsvTable& table) {
  RowReader(cursor, layout, table).read_all();
}

}  // namespace tribolog
