#pragma once
// What holds for every table that a reader returns.

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <set>
#include <string>
#include <vector>

#include "ingest/log/log_table.h"

namespace tribolog::fuzz {

inline void require(bool holds) {
  if (!holds) std::abort();
}

/// Rows and gaps that agree; nothing infinite.
inline void check_columns(const ingest::log::LogTable& table) {
  require((table.rows > 0 || !table.refusal.empty()) &&
          table.columns.size() <= table.header.size());
  for (const ingest::log::LogColumn& column : table.columns) {
    require(column.values.size() == table.rows);
    std::size_t gaps = 0;
    for (const double value : column.values) {
      require(!std::isinf(value));
      gaps += std::isnan(value) ? 1 : 0;
    }
    require(gaps == column.gaps);
  }
}

/// And names that differ.
inline void check_tables(const std::vector<ingest::log::LogTable>& tables) {
  require(!tables.empty());
  for (const ingest::log::LogTable& table : tables) {
    check_columns(table);
    std::set<std::string> names;
    for (const ingest::log::LogColumn& column : table.columns) {
      require(names.insert(column.header.full).second);
    }
  }
}

}  // namespace tribolog::fuzz
