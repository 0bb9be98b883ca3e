#pragma once
// Columns of the logs that no recording uses: nothing is left out in silence.

#include <set>
#include <string>
#include <vector>

#include "ingest/log/log_table.h"

namespace tribolog {

class UnusedColumns {
 public:
  void add(const LogTable& table);
  /// One for all logs; empty if every column is used.
  [[nodiscard]] std::string note() const;

 private:
  std::vector<std::string> names_;  ///< Of all columns, in the order in which they came.
  std::set<std::string> known_;
  std::set<std::string> used_;
};

}  // namespace tribolog
