#pragma once
// The rows of a text log that hold nothing but numbers and gaps: nearly all rows of nearly all
// logs. A stretch of whole lines is read without regard to what stands before it, so that stretches
// can be read side by side.

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "ingest/log/log_table.h"
#include "ingest/text/csv_dialect.h"
#include "ingest/text/fields.h"

namespace tribolog::ingest::text {

/// What becomes of a column of the file.
struct PlainColumn {
  int slot{-1};  ///< Index among those read; -1: passed over.
  /// Of a clock that is read exactly: taken off.
  std::optional<ClockReading> start;
  log::ColumnReading reading{log::ColumnReading::number};
  /// Of words: those known so far; has to live on.
  const std::vector<std::string>* words{};
};

struct PlainLayout {
  Delimiter delimiter{};
  DecimalMark mark{DecimalMark::point};
  std::vector<PlainColumn> columns;  ///< Of the file.
  std::size_t slots{};
};

struct PlainRows {
  /// By slot; NaN where there is a gap. The first `rows` of each have a meaning.
  std::vector<std::vector<double>> values;
  std::vector<std::size_t> gaps;  ///< By slot.
  std::size_t rows{};             ///< And as many lines.
  std::size_t bytes{};            ///< Of these rows.
  bool is_whole{};                ///< No row of the text needs a closer look.
  bool any_lf{};                  ///< Lines end with LF,
  bool any_cr_lf{};               ///< or CR LF.
};

/// Reads rows from the start of `text` until its end or the first line that is not a row: a blank
/// one, a comment, quotes, text, another number of fields, a lone CR, no line end.
/// @param rows is overwritten; its memory is used again.
void read_plain_rows(std::string_view text, const PlainLayout& layout, PlainRows& rows);

// Long stretches of plain rows on all cores: while one is read, the one before it is appended to
// the columns and the one behind it is fetched.

class PlainStretches {
 public:
  /// @param columns of the table, in the order of the layout's slots; they have to live on.
  explicit PlainStretches(std::vector<log::LogColumn>& columns) : columns_(columns) {}

  struct Round {
    std::span<const PlainRows> parts;  ///< In their order; until the next round.
    bool is_whole{};                   ///< All of the text's lines, but for a last one without end.
  };

  /// Reads the plain rows at the start of `text`; their values come into the columns with the next
  /// round or finish().
  /// @param meanwhile runs beside; must not throw.
  Round read(std::string_view text, const PlainLayout& layout,
             const std::function<void()>& meanwhile);
  /// Appends what was read last.
  void finish();

 private:
  void append(std::size_t column);

  std::vector<log::LogColumn>& columns_;
  std::vector<PlainRows> parts_;    ///< Of the round that goes on; kept for their memory.
  std::vector<PlainRows> waiting_;  ///< Of the round before, the first ones
  std::size_t waiting_parts_{0};    ///< of which are to be appended.
  std::size_t waiting_bytes_{0};    ///< Of the text that they were read from.
};

}  // namespace tribolog::ingest::text
