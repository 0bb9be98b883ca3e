#include "ingest/csv_rows.h"

#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "ingest/clock_field.h"
#include "ingest/closest_match.h"
#include "ingest/number_field.h"

namespace tribolog {
namespace {

/// How the fields of each column that is read become numbers.
class SlotReadings {
 public:
  SlotReadings(std::size_t count, const RowLayout& layout) : layout_(layout), starts_(count) {
    for (const ColumnReading reading : layout.readings) {
      plain_.push_back(reading == ColumnReading::number && layout.mark == DecimalMark::point);
    }
  }

  /// Of the other columns the fields have to go through read().
  [[nodiscard]] bool are_plain_numbers(std::size_t slot) const { return plain_[slot]; }

  NumberField read(std::string_view field, std::size_t slot, LogTable& table) {
    const ColumnReading reading = layout_.readings[slot];
    if (reading == ColumnReading::number) return read_number(field, layout_.mark);
    const auto clock = reading == ColumnReading::iso_time ? read_iso_time(field)
                                                          : read_clock_number(field, layout_.mark);
    if (clock) {
      if (!starts_[slot]) set_start(*clock, slot, table);
      if (starts_[slot]->whole != 0) return {FieldKind::number, clock->since(*starts_[slot])};
    }
    NumberField number = read_number(field, layout_.mark);
    if (reading == ColumnReading::iso_time && number.kind == FieldKind::number) {
      number.kind = FieldKind::text;
    }
    if (number.kind == FieldKind::number && starts_[slot])
      number.value -= table.columns[slot].origin;
    return number;
  }

 private:
  /// A clock that counts from 1970 starts with its first reading; another from its own zero.
  void set_start(const ClockReading& first, std::size_t slot, LogTable& table) {
    constexpr std::int64_t since_1970 = 100'000'000;
    const bool counts_from_1970 =
        layout_.readings[slot] == ColumnReading::iso_time || std::abs(first.whole) >= since_1970;
    starts_[slot] = ClockReading{counts_from_1970 ? first.whole : 0, 0.0};
    table.columns[slot].origin = static_cast<double>(starts_[slot]->whole);
    plain_[slot] = !counts_from_1970 && layout_.mark == DecimalMark::point;
  }

  const RowLayout& layout_;
  std::vector<std::optional<ClockReading>> starts_;
  std::vector<bool> plain_;
};

class RowReader {
 public:
  RowReader(RowCursor& cursor, const RowLayout& layout, CsvTable& table)
      : cursor_(cursor),
        layout_(layout),
        table_(table),
        delimiter_(static_cast<char>(table.delimiter)),
        values_(table.columns.size()),
        slots_(table.columns.size(), layout) {}

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
        const auto slot = static_cast<std::size_t>(layout_.slots[i]);
        double& value = values_[slot];
        std::from_chars_result read{p, std::errc::invalid_argument};
        if (slots_.are_plain_numbers(slot)) read = std::from_chars(p, end, value);
        if (read.ec == std::errc() && (read.ptr == end || *read.ptr == delimiter_) &&
            std::isfinite(value)) {
          p = read.ptr;
        } else {
          const char* const field_end = end_of_field(p, end);
          const NumberField field = slots_.read(
              std::string_view(p, static_cast<std::size_t>(field_end - p)), slot, table_);
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
      const auto slot = static_cast<std::size_t>(layout_.slots[i]);
      const NumberField number = slots_.read(fields[i].text, slot, table_);
      if (number.kind == FieldKind::text || number.kind == FieldKind::overflow) {
        if (may_be_cut && i + 1 == columns && looks_like_cut_number(fields[i].text, layout_.mark)) {
          return false;
        }
        refuse_field(fields[i], i, number.kind);
      }
      values_[slot] = number.value;
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
    if (layout_.header_row.empty()) return;
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
    std::string expected = "a number";
    if (layout_.readings[static_cast<std::size_t>(layout_.slots[column])] ==
        ColumnReading::iso_time) {
      expected = "a time such as 2026-03-01T08:15:00.25Z";
    } else if (layout_.mark == DecimalMark::comma) {
      expected = "a number with a decimal comma";
    }
    if (kind == FieldKind::overflow) {
      throw InputError({table_.file, cursor_.line(), static_cast<long>(field.column)},
                       {"column " + name + ": number is too large", in_quotes(field.text), "", ""});
    }
    if (layout_.mark == DecimalMark::point && looks_like_decimal_comma(field.text)) {
      hint = "decimal comma? state it: [log] decimal_comma = true";
    } else if (table_.rows == 0) {
      hint = "a row of units under the header? put '#' in front of it";
    }
    throw InputError({table_.file, cursor_.line(), static_cast<long>(field.column)},
                     {"column " + name, in_quotes(field.text), expected, hint});
  }

  RowCursor& cursor_;
  const RowLayout& layout_;
  CsvTable& table_;
  char delimiter_;
  std::vector<double> values_;
  SlotReadings slots_;
  bool has_trailing_delimiter_{false};
};

}  // namespace

void read_rows(RowCursor& cursor, const RowLayout& layout, CsvTable& table) {
  RowReader(cursor, layout, table).read_all();
}

}  // namespace tribolog
