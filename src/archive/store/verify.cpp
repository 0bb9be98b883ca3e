// Everything an archive holds, held against its digests and its chain.

#include <map>
#include <set>

#include <fmt/format.h>

#include "archive/sql/sqlite_connection.h"
#include "archive/store/calibration_archive.h"
#include "archive/store/digest.h"
#include "archive/store/entry_rows.h"

#include "error.h"

namespace tribolog::archive {
namespace {

std::string short_id(const std::string& id) { return id.substr(0, shown_digits); }

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
    if (event.what == "added") entries[event.id] = event.digest;
    if (event.what == "report") reports[event.id] = event.digest;
    if (event.what == "reviewed") reviews[event.id].push_back(event.digest);
    if (event.what == "removed") {
      reviews.erase(event.id);
      entries.erase(event.id);
      reports.erase(event.id);
    }
  }

  std::map<std::string, std::string> entries;               ///< Id and digest.
  std::map<std::string, std::string> reports;               ///< Id and fingerprint.
  std::map<std::string, std::vector<std::string>> reviews;  ///< Id and digests in their order.

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

}  // namespace

Verification CalibrationArchive::verify(
    const std::string& head, const std::function<void(std::size_t, std::size_t)>& progress) {
  Verification outcome;
  if (connection_->dialect() == sql::Dialect::sqlite) {
    outcome.faults = sql::faults_of_sqlite(*connection_);
  }
  connection_->read([&] {
    ChainReader chain(outcome, head);
    for (const sql::Row& row : connection_->run(
             "SELECT number, at_utc, what, id, digest, chain FROM event ORDER BY number")) {
      chain.take(row);
    }
    const std::vector<Entry> entries = list({});
    outcome.entries = entries.size();
    std::size_t done = 0;
    for (const Entry& entry : entries) {
      if (progress) progress(done++, entries.size());
      const auto fault = [&](const std::string& what) {
        outcome.faults.push_back(short_id(entry.id) + ": " + what);
      };
      const auto known = chain.entries.find(entry.id);
      if (known == chain.entries.end()) {
        fault("stands in no event: it was not added by tribolog");
      } else if (known->second != entry.digest) {
        fault("its digest is not the one it was added with");
      }
      std::string calibration_sha256;
      bool has_report = false;
      for (const StoredDocument& stored : documents(entry)) {
        ++outcome.documents;
        if (stored.kind == DocumentKind::calibration) calibration_sha256 = stored.sha256;
        if (stored.kind == DocumentKind::report) {
          has_report = true;
          const auto report = chain.reports.find(entry.id);
          if (report == chain.reports.end() || report->second != stored.sha256) {
            fault("its report is not the one that was archived");
          }
        }
        try {
          if (!document(entry, stored.kind, stored.name)) {
            fault("its " + to_string(stored.kind) + " is missing");
          }
        } catch (const ArchiveError&) {
          fault("its " + to_string(stored.kind) + " is damaged");
        }
      }
      if (!has_report && chain.reports.count(entry.id) > 0) fault("its report is missing");
      std::vector<std::string> review_digests;
      for (const Review& review : reviews(entry)) {
        review_digests.push_back(digest_of(entry.id, review_digests.size(), review));
      }
      if (review_digests != chain.reviews[entry.id]) {
        fault("its reviews are not those that were given");
      }
      const std::string digest =
          digest_of(entry.id, entry.facts, quantities(entry), inputs(entry), calibration_sha256);
      if (digest != entry.digest) fault("was altered: its digest is not that of what it says");
      if (known != chain.entries.end()) chain.entries.erase(known);
    }
    for (const auto& [id, digest] : chain.entries) {
      outcome.faults.push_back(short_id(id) + ": is missing, and was not removed by tribolog");
    }
  });
  if (!outcome.contains_head) {
    outcome.faults.push_back("the chain does not hold the link " + printable(head));
  }
  return outcome;
}

}  // namespace tribolog::archive
