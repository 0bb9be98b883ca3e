#pragma once
// Long stretches of plain rows on all cores: while one is read, the one before it is appended to
// the columns and the one behind it is fetched.

#include <cstddef>
#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "ingest/log/log_table.h"
#include "ingest/text/plain_rows.h"

namespace tribolog {

class PlainStretches {
 public:
  /// @param columns of the table, in the order of the layout's slots; they have to live on.
  explicit PlainStretches(std::vector<LogColumn>& columns) : columns_(columns) {}

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

  std::vector<LogColumn>& columns_;
  std::vector<PlainRows> parts_;    ///< Of the round that goes on; kept for their memory.
  std::vector<PlainRows> waiting_;  ///< Of the round before, the first ones
  std::size_t waiting_parts_{0};    ///< of which are to be appended.
  std::size_t waiting_bytes_{0};    ///< Of the text that they were read from.
};

}  // namespace tribolog
