#include "ingest/text/csv_rows.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "base/closest_match.h"
#include "base/requirements.h"
#include "ingest/text/fields.h"
#include "ingest/text/plain_rows.h"

namespace tribolog::ingest::text {
namespace {

/// How the fields of each column that is read become numbers.
class SlotReadings {
 public:
  SlotReadings(std::size_t count, const RowLayout& layout) : layout_(layout), starts_(count) {}

  /// Nothing as long as a clock has not been read.
  [[nodiscard]] std::optional<PlainLayout> plain_layout(const CsvTable& table) const {
    PlainLayout plain{table.delimiter, layout_.mark, {}, starts_.size()};
    for (const int slot : layout_.slots) {
      PlainColumn column;
      column.slot = slot;
      const auto at = static_cast<std::size_t>(slot);
      if (slot >= 0 && layout_.readings[at] == log::ColumnReading::words) {
        column.words = &table.columns[at].words;
      } else if (slot >= 0 && layout_.readings[at] != log::ColumnReading::number) {
        if (!starts_[at]) return std::nullopt;
        column.reading = layout_.readings[at];
        const bool is_text = column.reading != log::ColumnReading::clock;
        if (is_text || starts_[at]->whole != 0) column.start = starts_[at];
      }
      plain.columns.push_back(column);
    }
    return plain;
  }

  NumberField read(std::string_view field, std::size_t slot, log::LogTable& table) {
    const log::ColumnReading reading = layout_.readings[slot];
    if (reading == log::ColumnReading::number) return read_number(field, layout_.mark);
    if (reading == log::ColumnReading::words) return place_of(field, table.columns[slot].words);
    const bool is_text = reading != log::ColumnReading::clock;
    const auto clock = read_time(field, reading, layout_.mark);
    if (clock) {
      if (!starts_[slot]) set_start(*clock, slot, table);
      if (is_text || starts_[slot]->whole != 0) {
        return {FieldKind::number, clock->since(*starts_[slot])};
      }
    }
    NumberField number = read_number(field, layout_.mark);
    if (is_text && number.kind == FieldKind::number) number.kind = FieldKind::text;
    if (number.kind == FieldKind::number && starts_[slot])
      number.value -= table.columns[slot].origin;
    return number;
  }

 private:
  /// A clock that counts from 1970 starts with its first reading; another from its own zero.
  void set_start(const ClockReading& first, std::size_t slot, log::LogTable& table) {
    const log::ColumnReading reading = layout_.readings[slot];
    const bool is_epoch = reading == log::ColumnReading::iso_time ||
                          reading == log::ColumnReading::date ||
                          std::abs(static_cast<double>(first.whole)) >= log::counts_from_1970;
    const ClockReading start{is_epoch ? first.whole : 0, 0.0};
    starts_[slot] = start;
    table.columns[slot].origin = static_cast<double>(start.whole);
  }

  /// Among the words known so far, to which it is added. A log of which each row says something
  /// else has gaps from some row on.
  static NumberField place_of(std::string_view field, std::vector<std::string>& words) {
    constexpr std::size_t most_words = 4096;
    const auto known = std::find(words.begin(), words.end(), field);
    const bool is_new = known == words.end();
    if (field.empty() || (is_new && words.size() >= most_words)) {
      return {FieldKind::gap, std::numeric_limits<double>::quiet_NaN()};
    }
    const auto place = static_cast<double>(known - words.begin());
    if (is_new) words.emplace_back(field);
    return {FieldKind::number, place};
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
        slots_(table.columns.size(), layout),
        stretches_(table.columns) {}

  /// By turns: rows that need a closer look one by one, all others in long stretches.
  void read_all() {
    while (cursor_.next()) {
      try {
        if (!read_any_row()) {
          note_cut_row();
          break;
        }
        if (!cursor_.has_line_end()) note_missing_line_end();
      } catch (const InputError& refusal) {
        if (!layout_.skip_bad_rows) throw;
        count_bad_row(refusal);
        continue;
      }
      if (std::exchange(is_remark_, false)) {
        if (remarks_++ == 0) first_remark_ = std::string(trimmed(cursor_.row()));
        continue;
      }
      if (std::exchange(is_unclear_, false)) {
        if (table_.unclear_rows++ == 0) first_unclear_line_ = cursor_.line();
        continue;
      }
      if (cursor_.line() != expected_line_) {
        table_.line_breaks.emplace_back(table_.rows, cursor_.line());
      }
      expected_line_ = cursor_.line() + 1;
      keep();
      if (!layout_.joint_states && ++rows_since_stretch_ >= patience_ &&
          slots_.plain_layout(table_))
        read_stretch();
    }
    if (table_.bad_rows > 0) judge_bad_rows();
    if (remarks_ > 0) note_remarks();
    if (table_.unclear_rows > 0) {
      table_.notes.push_back({"reading.unclear_joint_states",
                              {{"unclear", table_.unclear_rows},
                               {"rows", table_.rows + table_.unclear_rows},
                               {"line", first_unclear_line_}}});
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
      const auto round = stretches_.read(cursor_.rest(), present(slots_.plain_layout(table_)),
                                         [&] { cursor_.read_ahead(stretch_bytes); });
      for (const PlainRows& part : round.parts) pass(part);
      goes_on = round.is_whole;
    }
    stretches_.finish();
    rows_since_stretch_ = 0;
    patience_ = table_.rows - before >= few ? 1 : std::min(2 * patience_, longest_wait);
  }

  void pass(const PlainRows& part) {
    if (part.rows == 0) return;
    if (cursor_.line() + 1 != expected_line_) {
      table_.line_breaks.emplace_back(table_.rows, cursor_.line() + 1);
    }
    table_.rows += part.rows;
    cursor_.pass(part.bytes, part.rows, part.any_lf, part.any_cr_lf);
    expected_line_ = cursor_.line() + 1;
  }

  /// Any row; `is_unclear_` where nothing says what its numbers are.
  /// @return false for a last row that is cut off. @throw InputError
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
    if (layout_.joint_states && !layout_.joint_states->lay_out(fields)) {
      is_unclear_ = !may_be_cut;
      return is_unclear_;
    }
    const std::size_t columns = layout_.slots.size();
    if (fields.size() == columns + 1 && fields.back().text.empty()) {
      fields.pop_back();
      note_once(has_trailing_delimiter_, Code{"reading.trailing_delimiter"});
    } else if (fields.size() + 1 == columns && layout_.header.back().text.empty()) {
      fields.push_back({"", cursor_.row().size() + 1});
    }
    refuse_repeated_header();
    if (is_remark(fields)) {
      is_remark_ = true;
      return true;
    }
    const bool ends_with_delimiter = fields.back().text.empty() && !cursor_.row().ends_with('"') &&
                                     !layout_.header.back().text.empty();
    if (may_be_cut && (fields.size() < columns || ends_with_delimiter)) return false;
    if (fields.size() != columns) refuse_ragged_row(row(), fields.size());
    for (std::size_t i = 0; i < columns; ++i) {
      if (layout_.slots[i] < 0) continue;
      const auto slot = static_cast<std::size_t>(layout_.slots[i]);
      const NumberField number = slots_.read(fields[i].text, slot, table_);
      const bool is_dash = fields[i].text == "-";  // a gap, or all that came of a number
      if (number.kind == FieldKind::text || number.kind == FieldKind::overflow || is_dash) {
        if (may_be_cut && i + 1 == columns && looks_like_cut_number(fields[i].text, layout_.mark)) {
          return false;
        }
      }
      if (number.kind == FieldKind::text || number.kind == FieldKind::overflow) {
        refuse_field(row(), fields[i], i, number.kind);
      }
      values_[slot] = number.value;
    }
    return true;
  }

  /// A line of words among rows of numbers, as a program says "EOF" or "homing done": fewer fields
  /// than the header has, and none a number.
  [[nodiscard]] bool is_remark(const std::vector<Field>& fields) const {
    constexpr std::size_t most = 1000;
    if (fields.size() >= layout_.slots.size() || remarks_ >= most || layout_.joint_states) {
      return false;
    }
    return !looks_like_gap(fields) &&
           std::all_of(fields.begin(), fields.end(), [&](const Field& field) {
             return read_number(field.text, layout_.mark).kind == FieldKind::text &&
                    !has_digit(field.text);
           });
  }
  static bool has_digit(const std::string& text) {
    return text.find_first_of("0123456789") != std::string::npos;
  }
  static bool looks_like_gap(const std::vector<Field>& fields) {
    return std::all_of(fields.begin(), fields.end(),
                       [](const Field& field) { return field.text.empty(); });
  }

  void note_remarks() {
    constexpr std::size_t longest = 60;
    table_.remark_rows = remarks_;
    table_.notes.push_back(
        {"reading.remarks",
         {{"lines", remarks_}, {"first", in_quotes(first_remark_.substr(0, longest))}}});
  }

  void keep() {
    for (std::size_t k = 0; k < values_.size(); ++k) {
      log::LogColumn& column = table_.columns[k];
      column.values.push_back(values_[k]);
      if (std::isnan(values_[k])) ++column.gaps;
    }
    ++table_.rows;
  }

  void note_once(bool& done, const Statement& note) {
    if (!std::exchange(done, true)) table_.notes.push_back(note);
  }

  void count_bad_row(const InputError& refusal) {
    constexpr std::size_t enough = 1000;  // where most rows are bad, not all need be read
    if (table_.bad_rows++ == 0) first_bad_row_ = refusal;
    if (table_.bad_rows >= enough && table_.bad_rows > table_.rows) judge_bad_rows();
  }

  void judge_bad_rows() {
    const std::size_t all = table_.rows + table_.bad_rows;
    const std::string first = present(first_bad_row_).what();
    if (static_cast<double>(table_.bad_rows) > most_bad_rows * static_cast<double>(all)) {
      throw InputError(
          {table_.file, present(first_bad_row_).where().line, 0},
          {fmt::format("{} of {} rows cannot be used", table_.bad_rows, all), "",
           fmt::format("no more than {} %", 100 * most_bad_rows), "the first: " + first});
    }
    table_.notes.push_back(
        {"reading.bad_rows", {{"bad", table_.bad_rows}, {"rows", all}, {"first", first}}});
  }

  void note_cut_row() {
    ++table_.cut_rows;
    table_.notes.push_back({"reading.ends_inside_row", {{"byte", cursor_.bytes_walked()}}});
  }

  void note_missing_line_end() { table_.notes.push_back(Code{"reading.no_last_line_end"}); }

  void refuse_repeated_header() const {
    if (layout_.header_row.empty()) return;
    if (trimmed(cursor_.row()) == trimmed(layout_.header_row)) refuse_second_header(row());
  }

  [[nodiscard]] RefusedRow row() const {
    return {table_, layout_, cursor_.line(), cursor_.row(), cursor_.rest()};
  }

  RowCursor& cursor_;
  const RowLayout& layout_;
  CsvTable& table_;
  std::vector<double> values_;
  SlotReadings slots_;
  PlainStretches stretches_;
  long expected_line_{-1};
  std::size_t rows_since_stretch_{0};
  std::size_t patience_{1};
  bool has_trailing_delimiter_{false};
  bool is_unclear_{false};
  bool is_remark_{false};
  std::size_t remarks_{0};
  std::string first_remark_;
  long first_unclear_line_{0};
  std::optional<InputError> first_bad_row_;
};

}  // namespace

void read_rows(RowCursor& cursor, const RowLayout& layout, CsvTable& table) {
  RowReader(cursor, layout, table).read_all();
}

}  // namespace tribolog::ingest::text
