#include "ingest/text/csv_rows.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "parallel/parallel_for.h"

#include "ingest/closest_match.h"
#include "ingest/text/clock_field.h"
#include "ingest/text/number_field.h"
#include "ingest/text/plain_rows.h"

namespace tribolog {
namespace {

/// How the fields of each column that is read become numbers.
class SlotReadings {
 public:
  SlotReadings(std::size_t count, const RowLayout& layout) : layout_(layout), starts_(count) {}

  /// Nothing as long as a clock has not been read.
  [[nodiscard]] std::optional<PlainLayout> plain_layout(const CsvTable& table) const {
    PlainLayout plain{table.delimiter, layout_.mark, {}, starts_.size()};
    for (const int slot : layout_.slots) {
      PlainColumn column{slot, {}, false};
      const auto at = static_cast<std::size_t>(slot);
      if (slot >= 0 && layout_.readings[at] != ColumnReading::number) {
        if (!starts_[at]) return std::nullopt;
        column.is_iso_time = layout_.readings[at] == ColumnReading::iso_time;
        if (starts_[at]->whole != 0) column.start = starts_[at];
      }
      plain.columns.push_back(column);
    }
    return plain;
  }

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
    const bool is_epoch = layout_.readings[slot] == ColumnReading::iso_time ||
                          std::abs(static_cast<double>(first.whole)) >= counts_from_1970;
    starts_[slot] = ClockReading{is_epoch ? first.whole : 0, 0.0};
    table.columns[slot].origin = static_cast<double>(starts_[slot]->whole);
  }

  const RowLayout& layout_;
  std::vector<std::optional<ClockReading>> starts_;
};

class RowReader {
 public:
  RowReader(RowCursor& cursor, const RowLayout& layout, CsvTable& table)
      : cursor_(cursor),
        layout_(layout),
        table_(table),
        values_(table.columns.size()),
        slots_(table.columns.size(), layout) {}

  /// By turns: rows that need a closer look one by one, all others in long stretches.
  void read_all() {
    while (cursor_.next()) {
      if (!read_any_row()) {
        note_cut_row();
        return;
      }
      if (cursor_.line() != expected_line_) {
        table_.line_breaks.emplace_back(table_.rows, cursor_.line());
      }
      expected_line_ = cursor_.line() + 1;
      keep();
      if (++rows_since_stretch_ >= patience_ && slots_.plain_layout(table_)) read_stretch();
    }
  }

 private:
  /// As many plain rows as follow. Where few did, the next try waits: a log with quotes in every
  /// row has none.
  void read_stretch() {
    constexpr std::size_t few = 64;
    constexpr std::size_t stretch_bytes = std::size_t{1} << 23;
    constexpr std::size_t longest_wait = 4096;
    const std::size_t before = table_.rows;
    for (bool goes_on = true; goes_on;) {
      cursor_.read_on(stretch_bytes);
      std::vector<PlainRows> parts =
          read_side_by_side(cursor_.rest(), *slots_.plain_layout(table_));
      const auto last = std::find_if(parts.begin(), parts.end(),
                                     [](const PlainRows& part) { return !part.is_whole; });
      goes_on = !parts.empty() && last == parts.end();
      if (last != parts.end()) parts.erase(last + 1, parts.end());
      append(parts);
    }
    rows_since_stretch_ = 0;
    patience_ = table_.rows - before >= few ? 1 : std::min(2 * patience_, longest_wait);
  }

  void append(const std::vector<PlainRows>& parts) {
    // Column by column: most of the time goes into memory that is touched for the first time.
    parallel_for(table_.columns.size(), [&](std::size_t k) {
      LogColumn& column = table_.columns[k];
      for (const PlainRows& part : parts) {
        column.values.insert(column.values.end(), part.values[k].begin(), part.values[k].end());
        column.gaps += part.gaps[k];
      }
    });
    for (const PlainRows& part : parts) {
      if (part.rows == 0) continue;
      if (cursor_.line() + 1 != expected_line_) {
        table_.line_breaks.emplace_back(table_.rows, cursor_.line() + 1);
      }
      table_.rows += part.rows;
      cursor_.pass(part.bytes, part.rows, part.any_lf, part.any_cr_lf);
      expected_line_ = cursor_.line() + 1;
    }
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
    const bool ends_with_delimiter = fields.back().text.empty() && !cursor_.row().ends_with('"') &&
                                     !layout_.header.back().text.empty();
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
  std::vector<double> values_;
  SlotReadings slots_;
  long expected_line_{-1};
  std::size_t rows_since_stretch_{0};
  std::size_t patience_{1};
  bool has_trailing_delimiter_{false};
};

}  // namespace

void read_rows(RowCursor& cursor, const RowLayout& layout, CsvTable& table) {
  RowReader(cursor, layout, table).read_all();
}

}  // namespace tribolog
