#include "ingest/measurement/measured_log.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include <fmt/format.h>

#include "base/closest_match.h"
#include "base/error.h"
#include "ingest/text/csv_dialect.h"
#include "wording/words.h"

namespace tribolog::ingest::measurement {
namespace {

constexpr std::size_t most_listed = 12;

/// Names that are taken, and for each how often it was wanted: the search for a free one goes on
/// from there.
class FreeNames {
 public:
  std::string next(const std::string& wanted) {
    std::size_t& uses = uses_[wanted];
    ++uses;
    std::string name = uses == 1 ? wanted : fmt::format("{}_{}", wanted, uses);
    while (!taken_.insert(name).second) name = fmt::format("{}_{}", wanted, ++uses);
    return name;
  }

 private:
  std::map<std::string, std::size_t> uses_;
  std::set<std::string> taken_;
};

void make_names_differ(log::LogTable& table) {
  FreeNames names;
  std::vector<std::string> repeated;
  for (log::LogColumn& column : table.columns) {
    log::ColumnHeader& header = column.header;
    const std::string name = names.next(header.full);
    if (name != header.full) {
      if (repeated.empty() || repeated.back() != header.full) repeated.push_back(header.full);
      header.full = header.name = name;
    }
    table.header.push_back(header.full);
  }
  if (repeated.empty()) return;
  table.notes.push_back({"reading.repeated_names", {{"columns", list_of_names(repeated)}}});
}

}  // namespace

log::LogColumn column_of(const std::string& name, const std::string& unit,
                         std::vector<double> values) {
  // Beside a unit of its own "q[0]" is a name and nothing else.
  log::LogColumn column{
      unit.empty() ? text::read_header_field(name) : log::ColumnHeader{name, name, unit},
      std::move(values), 0};
  for (double& value : column.values) {
    if (std::isfinite(value)) continue;
    value = std::numeric_limits<double>::quiet_NaN();
    ++column.gaps;
  }
  return column;
}

void MeasuredLog::leave_out(const std::string& name, const std::string& reason) {
  if (left_out_.size() < most_listed) {
    left_out_.push_back({"reading.not_read", {{"name", in_quotes(name)}, {"why", reason}}});
  } else {
    ++more_left_out_;
  }
}

void MeasuredLog::add(log::LogTable table) {
  table.file = file_;
  make_names_differ(table);
  tables_.push_back(std::move(table));
}

std::vector<Statement> MeasuredLog::notes() const {
  std::vector<Statement> all = notes_;
  all.insert(all.end(), left_out_.begin(), left_out_.end());
  if (more_left_out_ > 0) all.push_back({"reading.more_not_read", {{"arrays", more_left_out_}}});
  return all;
}

std::vector<log::LogTable> MeasuredLog::finish() && {
  const std::vector<Statement> all = notes();
  if (tables_.empty()) {
    Statement held;
    for (const Statement& note : all) held.add(note);
    throw InputError({file_, 0, 0}, {"holds no channel with numbers that can be read",
                                     held.empty() ? "nothing" : wording::words(held),
                                     "a channel with a number for each sample", ""});
  }
  if (std::all_of(tables_.begin(), tables_.end(),
                  [](const log::LogTable& table) { return !table.refusal.empty(); })) {
    throw InputError({file_, 0, 0}, {tables_.front().refusal, "", "", ""});
  }
  FreeNames names;
  for (log::LogTable& table : tables_) {
    // The only one needs no name; nothing would distinguish two of one name.
    table.group = tables_.size() == 1 ? "" : names.next(table.group);
  }
  tables_.front().notes.insert(tables_.front().notes.begin(), all.begin(), all.end());
  return std::move(tables_);
}

}  // namespace tribolog::ingest::measurement
