// Everything an archive holds, held against its digests and its chain.

#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "archive/sql/databases.h"
#include "archive/store/calibration_archive.h"
#include "archive/store/digest.h"
#include "archive/store/entry_rows.h"
#include "archive/store/schema.h"
#include "base/error.h"

namespace tribolog::archive::store {
namespace {

std::string short_id(const std::string& id) { return id.substr(0, calibration::shown_digits); }

/// The chain's links, and what has to be there by them.
class ChainReader {
 public:
  ChainReader(Verification& outcome, const std::string& wanted_head)
      : outcome_(outcome), wanted_(wanted_head) {
    outcome_.contains_head = wanted_.empty();
  }

  void take(const sql::Row& row) {
    const Event event{row[0].integer(), row[1].text(), row[2].text(), row[3].text(), row[4].text()};
    ++outcome_.events;
    if (event.number != static_cast<std::int64_t>(outcome_.events) && !is_broken_) {
      fault(outcome_.events, "is missing");
    }
    const std::string link = chain_link(outcome_.head, event);
    if (link != row[5].text() && !is_broken_) {
      fault(outcome_.events, "was altered");
    }
    outcome_.head = row[5].text();
    outcome_.contains_head = outcome_.contains_head || outcome_.head == wanted_;
    if (event.what == "added") {
      entries.digests[event.id] = event.digest;
      added[event.id] = ++additions;
    }
    if (event.what == "report") entries.reports[event.id] = event.digest;
    if (event.what == "reviewed") entries.reviews[event.id].push_back(event.digest);
    if (event.what == "removed") {
      ++removals;
      entries.digests.erase(event.id);
      entries.reports.erase(event.id);
      entries.reviews.erase(event.id);
    }
  }

  ChainedEntries entries;
  std::map<std::string, std::int64_t> added;  ///< As which addition, from 1 on.
  std::int64_t additions{};
  std::int64_t removals{};

 private:
  void fault(std::size_t event, const char* what) {
    outcome_.faults.push_back(
        fmt::format("the chain of additions and removals is broken: event {} {}", event, what));
    is_broken_ = true;  // all further links follow from the one that is wrong
  }

  Verification& outcome_;
  std::string wanted_;
  bool is_broken_{false};
};

/// Rows that belong to nothing, which a server whose rules were switched off may hold too.
void find_strays(sql::Connection& connection, int version, std::vector<std::string>& faults) {
  const auto look = [&](const char* table, const char* column, const char* parent) {
    const sql::Rows rows = connection.run(fmt::format(
        "SELECT count(*) FROM {} WHERE {} NOT IN (SELECT number FROM {})", table, column, parent));
    if (rows.front().front().integer() == 0) return;
    faults.push_back(fmt::format("rows of the table {} belong to no {}", table, parent));
  };
  for (const char* const table : {"quantity", "input", "document"}) {
    look(table, "calibration", "calibration");
  }
  if (version >= first_schema_with_reviews) look("review", "calibration", "calibration");
  look("content", "document", "document");
}

/// Numbers are given once, in the order of the additions.
void check_order(std::vector<calibration::Entry> entries, ChainReader& chain,
                 std::vector<std::string>& faults) {
  std::sort(
      entries.begin(), entries.end(),
      [](const calibration::Entry& a, const calibration::Entry& b) { return a.number < b.number; });
  std::int64_t before = 0;
  for (const calibration::Entry& entry : entries) {
    const std::int64_t addition = chain.added[entry.id];
    if (addition < before) faults.push_back(short_id(entry.id) + ": has another one's number");
    before = addition;
  }
}

/// SQLite counts what was ever added. Documents of removed calibrations are in no event.
void check_counters(sql::Connection& connection, const ChainReader& chain,
                    std::vector<std::string>& faults) {
  const auto fault = [&](const char* table) {
    faults.push_back(fmt::format("the counter of the table {} is not that of its rows", table));
  };
  const auto counter_of = [&](const char* table) {
    const sql::Rows rows =
        connection.run("SELECT seq FROM sqlite_sequence WHERE name = $1", {table});
    if (rows.size() > 1) fault(table);
    return rows.empty() ? 0 : rows.front().front().integer();
  };
  const sql::Rows foreign = connection.run(
      "SELECT count(*) FROM sqlite_sequence WHERE name NOT IN ('calibration', 'document')");
  if (foreign.front().front().integer() != 0) fault("sqlite_sequence");
  if (counter_of("calibration") != chain.additions) fault("calibration");
  const sql::Row documents =
      connection.run("SELECT count(*), COALESCE(max(number), 0) FROM document").front();
  const std::int64_t counted = counter_of("document");
  const bool fits = chain.removals > 0
                        ? counted >= documents[1].integer()
                        : counted == documents[0].integer() && counted == documents[1].integer();
  if (!fits) fault("document");
}

}  // namespace

Verification CalibrationArchive::verify(
    const std::string& head, const std::function<void(std::size_t, std::size_t)>& progress) {
  Verification outcome;
  const bool is_sqlite = connection_->dialect() == sql::Dialect::sqlite;
  if (is_sqlite) outcome.faults = sql::faults_of_sqlite(*connection_);
  connection_->read([&] {
    const int version = version_of(*connection_);
    ChainReader chain(outcome, head);
    for (const sql::Row& row : connection_->run(
             "SELECT number, at_utc, what, id, digest, chain FROM event ORDER BY number")) {
      chain.take(row);
    }
    const std::vector<calibration::Entry> entries = list({});
    outcome.entries = entries.size();
    std::size_t done = 0;
    for (const calibration::Entry& entry : entries) {
      if (progress) progress(done++, entries.size());
      const EntryProof proof = prove(*connection_, version, entry, chain.entries);
      outcome.documents += proof.documents;
      for (const std::string& fault : proof.faults) {
        outcome.faults.push_back(short_id(entry.id) + ": " + fault);
      }
      chain.entries.digests.erase(entry.id);
    }
    for (const auto& [id, digest] : chain.entries.digests) {
      outcome.faults.push_back(short_id(id) + ": is missing, and was not removed by tribolog");
    }
    find_strays(*connection_, version, outcome.faults);
    check_order(entries, chain, outcome.faults);
    if (is_sqlite) check_counters(*connection_, chain, outcome.faults);
  });
  if (!outcome.contains_head) {
    outcome.faults.push_back("the chain does not hold the link " + printable(head));
  }
  return outcome;
}

}  // namespace tribolog::archive::store
