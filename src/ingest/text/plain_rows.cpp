#include "ingest/text/plain_rows.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/parallel_for.h"
#include "ingest/text/csv_lines.h"
#include "ingest/text/plain_number.h"

namespace tribolog::ingest::text {

namespace {

class PlainRowReader {
 public:
  PlainRowReader(std::string_view text, const PlainLayout& layout, PlainRows& rows)
      : layout_(layout),
        by_blanks_(layout.delimiter == Delimiter::spaces),
        delimiter_(static_cast<char>(layout.delimiter)),
        mark_(layout.mark == DecimalMark::comma ? ',' : '.'),
        begin_(text.data()),
        end_(text.data() + text.size()),
        row_(layout.slots),
        out_(rows) {
    out_.values.resize(layout.slots);
    out_.gaps.assign(layout.slots, 0);
    out_.rows = 0;
    out_.any_lf = out_.any_cr_lf = false;
    for (const PlainColumn& column : layout.columns) {
      is_simple_ = is_simple_ && !by_blanks_ && column.slot >= 0 && !column.start && !column.words;
      slot_of_.push_back(static_cast<std::size_t>(std::max(column.slot, 0)));
    }
    constexpr std::size_t usual_row_bytes = 32;
    constexpr std::size_t usual_field_bytes = 4;  // at the least, or a wide log takes all memory
    const std::size_t row_bytes =
        std::max(usual_row_bytes, usual_field_bytes * layout.columns.size());
    make_room(text.size() / row_bytes + 1);
  }

  void read() {
    const char* p = begin_;
    while (p != end_) {
      if (out_.rows == room_) make_room(2 * room_);
      const char* next = is_simple_ ? read_simple_row(p) : nullptr;
      if (next == nullptr) {
        next = read_row(p);
        if (next == nullptr) break;
        keep_row();
      }
      p = next;
      ++out_.rows;
    }
    out_.bytes = static_cast<std::size_t>(p - begin_);
    out_.is_whole = p == end_;
  }

 private:
  void make_room(std::size_t rows) {
    room_ = rows;
    to_.clear();
    for (auto& values : out_.values) {
      if (values.size() < rows) values.resize(rows);
      to_.push_back(values.data());
    }
  }

  void keep_row() {
    for (std::size_t k = 0; k < row_.size(); ++k) {
      to_[k][out_.rows] = row_[k];
      out_.gaps[k] += std::isnan(row_[k]) ? 1 : 0;
    }
  }

  /// A row of nothing but numbers, all of them wanted: most rows of most logs.
  /// @return the start of the next line; null where the row needs a closer look.
  const char* read_simple_row(const char* p) {
    const std::size_t columns = layout_.columns.size();
    for (std::size_t i = 0; i < columns; ++i) {
      double value;
      const char* const behind = read_plain_number(p, end_, mark_, value);
      const char expected = i + 1 < columns ? delimiter_ : '\n';
      if (behind == p || behind == end_ || *behind != expected) return nullptr;
      to_[slot_of_[i]][out_.rows] = value;
      p = behind + 1;
    }
    out_.any_lf = true;
    return p;
  }

  [[nodiscard]] static bool is_blank(char c) { return c == ' ' || c == '\t'; }
  [[nodiscard]] bool ends_field(char c) const {
    return c == '\n' || c == '\r' || (by_blanks_ ? is_blank(c) : c == delimiter_);
  }
  [[nodiscard]] const char* end_of_field(const char* p) const {
    while (p != end_ && !ends_field(*p) && *p != '"') ++p;
    return p;
  }

  /// @return the start of the next line, or null.
  const char* read_row(const char* p) {
    const std::size_t columns = layout_.columns.size();
    const char* const first = behind_blanks(p);
    if (first == end_ || *first == '\n' || *first == '\r') return nullptr;
    if (starts_comment({first, static_cast<std::size_t>(end_ - first)})) return nullptr;
    if (by_blanks_) p = first;
    for (std::size_t i = 0; i < columns; ++i) {
      p = read_field(p, layout_.columns[i]);
      if (p == nullptr || p == end_) return nullptr;
      if (by_blanks_) p = behind_blanks(p);
      if (i + 1 == columns) return behind_line_end(p);
      if (p == end_ || *p == '\n' || *p == '\r') return nullptr;
      if (!by_blanks_) ++p;  // the delimiter
    }
    return nullptr;
  }

  [[nodiscard]] const char* behind_blanks(const char* p) const {
    while (p != end_ && is_blank(*p)) ++p;
    return p;
  }

  const char* behind_line_end(const char* p) {
    if (p == end_) return nullptr;
    if (*p == '\n') {
      out_.any_lf = true;
      return p + 1;
    }
    if (*p != '\r' || p + 1 == end_ || p[1] != '\n') return nullptr;
    out_.any_cr_lf = true;
    return p + 2;
  }

  /// @return the field's end, or null where it is no plain number or gap.
  const char* read_field(const char* p, const PlainColumn& column) {
    if (column.slot < 0) {
      p = end_of_field(p);
      return p != end_ && *p == '"' ? nullptr : p;
    }
    double& value = row_[static_cast<std::size_t>(column.slot)];
    while (p != end_ && *p == ' ') ++p;
    if (!column.start && column.words == nullptr) {
      const char* const behind = read_plain_number(p, end_, mark_, value);
      if (behind != p && behind != end_ && ends_field(*behind)) return behind;
    }
    const char* const field_end = end_of_field(p);
    if (field_end != end_ && *field_end == '"') return nullptr;
    const std::string_view field(p, static_cast<std::size_t>(field_end - p));
    if (column.words != nullptr) {
      const auto known = std::find(column.words->begin(), column.words->end(), trimmed(field));
      value = static_cast<double>(known - column.words->begin());
      return known != column.words->end() ? field_end : nullptr;
    }
    if (column.start) {
      const auto clock = read_time(field, column.reading, layout_.mark);
      if (clock) value = clock->since(*column.start);
      return clock ? field_end : nullptr;
    }
    const NumberField number = read_number(field, layout_.mark);
    value = number.value;
    const bool is_plain = number.kind == FieldKind::number || number.kind == FieldKind::gap;
    return is_plain ? field_end : nullptr;
  }

  const PlainLayout& layout_;
  bool by_blanks_;
  char delimiter_;
  char mark_;
  const char* begin_;
  const char* end_;
  std::vector<double> row_;
  PlainRows& out_;
  std::vector<double*> to_;  ///< Of each slot.
  std::vector<std::size_t> slot_of_;
  std::size_t room_{0};  ///< Rows for which there is room.
  bool is_simple_{true};
};

}  // namespace

void read_plain_rows(std::string_view text, const PlainLayout& layout, PlainRows& rows) {
  PlainRowReader(text, layout, rows).read();
}

namespace {

constexpr std::size_t stretch_bytes = std::size_t{1} << 19;

/// Starting a thread takes longer than reading a few lines.
std::size_t threads_for(std::size_t bytes) {
  constexpr std::size_t few_bytes = std::size_t{1} << 16;
  return bytes < few_bytes ? 1 : 0;
}

/// Of whole lines, about half a megabyte each.
std::vector<std::string_view> stretches_of(std::string_view text) {
  std::vector<std::string_view> stretches;
  while (!text.empty()) {
    const std::size_t bytes = std::min(stretch_bytes, text.size());
    const std::size_t line_end = text.substr(0, bytes).rfind('\n');
    if (line_end == std::string_view::npos) break;  // a long line, or the last one
    stretches.push_back(text.substr(0, line_end + 1));
    text.remove_prefix(line_end + 1);
  }
  return stretches;
}

}  // namespace

PlainStretches::Round PlainStretches::read(std::string_view text, const PlainLayout& layout,
                                           const std::function<void()>& meanwhile) {
  const std::vector<std::string_view> stretches = stretches_of(text);
  if (parts_.size() < stretches.size()) parts_.resize(stretches.size());
  const std::size_t columns = waiting_parts_ > 0 ? columns_.size() : 0;
  const auto work = [&](std::size_t k) {
    if (k == 0) {
      meanwhile();
    } else if (k <= columns) {
      append(k - 1);
    } else {
      const std::size_t i = k - 1 - columns;
      read_plain_rows(stretches[i], layout, parts_[i]);
    }
  };
  parallel_for(1 + columns + stretches.size(), work, threads_for(waiting_bytes_ + text.size()));
  waiting_bytes_ = text.size();
  const auto end = parts_.begin() + static_cast<std::ptrdiff_t>(stretches.size());
  const auto last =
      std::find_if(parts_.begin(), end, [](const PlainRows& part) { return !part.is_whole; });
  const bool is_whole = last == end;
  waiting_parts_ = static_cast<std::size_t>(last - parts_.begin()) + (is_whole ? 0 : 1);
  std::swap(parts_, waiting_);
  return {std::span(waiting_).first(waiting_parts_), is_whole && !stretches.empty()};
}

void PlainStretches::finish() {
  if (waiting_parts_ > 0) {
    parallel_for(columns_.size(), [&](std::size_t k) { append(k); }, threads_for(waiting_bytes_));
  }
  waiting_parts_ = 0;
}

void PlainStretches::append(std::size_t column) {
  log::LogColumn& to = columns_[column];
  for (const PlainRows& part : std::span(waiting_).first(waiting_parts_)) {
    const double* const first = part.values[column].data();
    to.values.insert(to.values.end(), first, first + part.rows);
    to.gaps += part.gaps[column];
  }
}

}  // namespace tribolog::ingest::text
