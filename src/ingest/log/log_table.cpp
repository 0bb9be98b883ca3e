#include "ingest/log/log_table.h"

#include <algorithm>
#include <iterator>

namespace tribolog::ingest::log {

long LogTable::line_of(std::size_t row) const {
  const auto after =
      std::upper_bound(line_breaks.begin(), line_breaks.end(), row,
                       [](std::size_t wanted, const auto& entry) { return wanted < entry.first; });
  if (after == line_breaks.begin()) return 0;
  const auto& [first_row, first_line] = *std::prev(after);
  return first_line + static_cast<long>(row - first_row);
}

}  // namespace tribolog::ingest::log
