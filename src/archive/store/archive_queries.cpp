// What an archive is asked.

#include <algorithm>
#include <map>
#include <tuple>

#include <fmt/format.h>

#include "archive/store/calibration_archive.h"
#include "archive/store/digest.h"
#include "archive/store/entry_rows.h"
#include "archive/store/schema.h"
#include "base/encodings.h"
#include "base/error.h"

namespace tribolog::archive::store {

namespace {

using sql::Row;
using sql::Rows;
using sql::Value;

/// " WHERE robot = $1 ...", and its parameters.
std::pair<std::string, std::vector<sql::Value>> conditions(const Filter& filter) {
  std::string text;
  std::vector<sql::Value> values;
  const auto add = [&](const char* column, const std::optional<std::string>& wanted) {
    if (!wanted) return;
    values.emplace_back(*wanted);
    text +=
        fmt::format("{} {} = ${}", values.size() == 1 ? " WHERE" : " AND", column, values.size());
  };
  add("robot", filter.robot);
  add("serial", filter.serial);
  add("joint", filter.joint);
  refuse_unkept_texts(values);
  if (filter.latest_revisions) {
    text += values.empty() ? " WHERE" : " AND";
    text +=
        " NOT EXISTS (SELECT 1 FROM calibration AS later WHERE later.identity = "
        "calibration.identity AND later.revision > calibration.revision)";
  }
  return {text, values};
}

auto place_of(const calibration::Entry& e) {
  return std::tie(e.facts.of.robot, e.facts.of.serial, e.facts.of.joint, e.facts.measured_at,
                  e.identity, e.revision);
}

}  // namespace

std::vector<calibration::Entry> CalibrationArchive::list(const Filter& filter) {
  const auto [where, values] = conditions(filter);
  std::vector<calibration::Entry> entries;
  for (const Row& row : connection_->run(
           fmt::format("SELECT {} FROM calibration{}", entry_columns, where), values)) {
    entries.push_back(entry_of(row));
  }
  // Not by the database, whose order of texts depends on its locale.
  std::sort(entries.begin(), entries.end(),
            [](const calibration::Entry& a, const calibration::Entry& b) {
              return place_of(a) < place_of(b);
            });
  return entries;
}

calibration::Decisions CalibrationArchive::decisions(const Filter& filter) {
  calibration::Decisions last;
  if (version_of(*connection_) < first_schema_with_reviews) return last;
  const auto [where, values] = conditions(filter);
  for (const Row& row :
       connection_->run("SELECT calibration.id, review.decision FROM review JOIN calibration ON "
                        "calibration.number = review.calibration" +
                            where + " ORDER BY review.calibration, review.place",
                        values)) {
    last[row[0].text()] = calibration::decision_of(row[1].text());
  }
  return last;
}

calibration::Entry CalibrationArchive::find(const std::string& digits) {
  constexpr std::size_t fewest = 4;
  const bool is_hex = digits.find_first_not_of("0123456789abcdef") == std::string::npos;
  if (digits.size() < fewest || !is_hex) {
    throw UsageError(
        fmt::format("{} is no id: at least {} of its hexadecimal digits are needed, as "
                    "`tribolog archive list` shows them",
                    printable(digits), fewest));
  }
  const Rows rows = connection_->run(
      fmt::format("SELECT {} FROM calibration WHERE id >= $1 AND id < $2 ORDER BY id LIMIT 2",
                  entry_columns),
      {digits, digits + "g"});
  if (rows.empty()) {
    throw UsageError(fmt::format("{}: no calibration has the id {}",
                                 printable(connection_->name(), longest_path), digits));
  }
  if (rows.size() > 1) {
    throw UsageError(fmt::format("{} is the start of several ids: {}..., {}...", digits,
                                 rows[0][1].text().substr(0, 2 * calibration::shown_digits),
                                 rows[1][1].text().substr(0, 2 * calibration::shown_digits)));
  }
  return entry_of(rows.front());
}

std::vector<calibration::Quantity> CalibrationArchive::quantities(const calibration::Entry& entry) {
  std::vector<calibration::Quantity> quantities;
  for (const Row& row :
       connection_->run(fmt::format("SELECT {} FROM quantity WHERE calibration = $1 ORDER BY place",
                                    quantity_columns),
                        {entry.number})) {
    quantities.push_back(quantity_of(row));
  }
  return quantities;
}

std::vector<calibration::Input> CalibrationArchive::inputs(const calibration::Entry& entry) {
  std::vector<calibration::Input> inputs;
  for (const Row& row : connection_->run(
           fmt::format("SELECT {} FROM input WHERE calibration = $1 ORDER BY place", input_columns),
           {entry.number})) {
    inputs.push_back(input_of(row));
  }
  return inputs;
}

std::vector<StoredDocument> CalibrationArchive::documents(const calibration::Entry& entry) {
  std::vector<StoredDocument> documents;
  for (const Row& row : connection_->run(
           fmt::format("SELECT {} FROM document WHERE calibration = $1 ORDER BY number",
                       document_columns),
           {entry.number})) {
    documents.push_back(stored_document_of(row));
  }
  return documents;
}

std::vector<calibration::Measured> CalibrationArchive::measured(const Filter& filter) {
  std::vector<calibration::Measured> found;
  connection_->read([&] {
    std::map<std::int64_t, std::size_t> place;
    for (calibration::Entry& entry : list(filter)) {
      place[entry.number] = found.size();
      found.push_back({std::move(entry), {}});
    }
    const auto [where, values] = conditions(filter);
    for (const Row& row : connection_->run(
             fmt::format("SELECT calibration, {} FROM calibration JOIN quantity ON "
                         "quantity.calibration = calibration.number{} ORDER BY calibration, place",
                         quantity_columns, where),
             values)) {
      found[place.at(row.front().integer())].quantities.push_back(quantity_of(row, 1));
    }
  });
  return found;
}

std::optional<std::string> CalibrationArchive::document(const calibration::Entry& entry,
                                                        calibration::DocumentKind kind,
                                                        const std::string& name) {
  const Rows rows = connection_->run(
      "SELECT zstd, bytes, sha256 FROM document JOIN content ON content.document = document.number "
      "WHERE calibration = $1 AND kind = $2 AND name = $3",
      {entry.number, to_string(kind), name});
  if (rows.empty()) return std::nullopt;
  std::string bytes =
      uncompressed(rows.front()[0].bytes(), static_cast<std::uint64_t>(rows.front()[1].integer()),
                   connection_->name());
  if (sha256_hex(bytes) != rows.front()[2].text()) {
    throw ArchiveError(printable(connection_->name(), longest_path) + ": the " + to_string(kind) +
                       " of " + entry.id.substr(0, calibration::shown_digits) +
                       " is not what was archived; restore a backup");
  }
  return bytes;
}

// What reviewers decided.

void CalibrationArchive::add_review(const calibration::Entry& entry,
                                    const calibration::Review& review) {
  refuse_unkept_texts(std::vector<sql::Value>{review.reviewer, review.note});
  connection_->write([&] {
    const std::size_t place = reviews(entry).size();
    connection_->run(fmt::format("INSERT INTO review (calibration, place, {}) VALUES "
                                 "($1, $2, $3, $4, $5, $6)",
                                 review_columns),
                     row_of(review, entry.number, place));
    append_event("reviewed", entry.id, digest_of(entry.id, place, review), review.at_utc);
  });
}

std::vector<calibration::Review> CalibrationArchive::reviews(const calibration::Entry& entry) {
  std::vector<calibration::Review> found;
  if (version_of(*connection_) < first_schema_with_reviews) return found;
  for (const sql::Row& row :
       connection_->run(fmt::format("SELECT {} FROM review WHERE calibration = $1 ORDER BY place",
                                    review_columns),
                        {entry.number})) {
    found.push_back(review_of(row));
  }
  return found;
}

std::optional<calibration::Entry> CalibrationArchive::find_report(const std::string& sha256) {
  const sql::Rows rows = connection_->run(
      fmt::format("SELECT {} FROM calibration WHERE number IN (SELECT calibration FROM document "
                  "WHERE kind = 'report' AND sha256 = $1) ORDER BY number LIMIT 1",
                  entry_columns),
      {sha256});
  return rows.empty() ? std::nullopt : std::optional(entry_of(rows.front()));
}

}  // namespace tribolog::archive::store
