#include "ingest/dataset/unused_columns.h"

#include "base/closest_match.h"

namespace tribolog {

void UnusedColumns::add(const LogTable& table) {
  for (const std::string& name : table.header) {
    if (!name.empty() && known_.insert(name).second) names_.push_back(name);
  }
  for (const LogColumn& column : table.columns) used_.insert(column.header.full);
}

std::string UnusedColumns::note() const {
  std::vector<std::string> unused;
  for (const std::string& name : names_) {
    if (used_.count(name) == 0) unused.push_back(name);
  }
  return unused.empty() ? "" : "columns of the logs that are not used: " + list_of_names(unused);
}

}  // namespace tribolog
