#include "archive/store/calibration_archive.h"

#include <fmt/format.h>

#include "archive/sql/databases.h"
#include "archive/store/digest.h"
#include "archive/store/entry_rows.h"
#include "archive/store/schema.h"
#include "base/encodings.h"
#include "base/error.h"

namespace tribolog::archive::store {
namespace {

using sql::Blob;
using sql::Row;
using sql::Rows;
using sql::Value;

/// "$1, $2, ..., $n"
std::string places(std::size_t count) {
  std::string text;
  for (std::size_t k = 1; k <= count; ++k) text += fmt::format("{}${}", k == 1 ? "" : ", ", k);
  return text;
}

}  // namespace

CalibrationArchive::CalibrationArchive(std::unique_ptr<sql::Connection> connection)
    : connection_(std::move(connection)) {
  refuse_other_versions(*connection_);
  refuse_damaged_schema(*connection_, version_of(*connection_));
}

Added CalibrationArchive::add(const calibration::NewCalibration& calibration, bool again,
                              const std::string& now_utc) {
  refuse_unkept_texts(calibration);
  Added added;
  connection_->write([&] { added = insert(calibration, again, now_utc); });
  return added;
}

std::vector<Added> CalibrationArchive::add(
    const std::vector<calibration::NewCalibration>& calibrations, bool again,
    const std::string& now_utc) {
  for (const calibration::NewCalibration& one : calibrations) refuse_unkept_texts(one);
  std::vector<Added> added;
  connection_->write([&] {
    added.clear();
    for (const calibration::NewCalibration& one : calibrations) {
      added.push_back(insert(one, again, now_utc));
    }
  });
  return added;
}

Added CalibrationArchive::insert(const calibration::NewCalibration& calibration, bool again,
                                 const std::string& now_utc) {
  calibration::Entry entry;
  entry.facts = calibration.facts;
  entry.identity = identity_of(calibration.inputs);
  const std::vector<StoredDocument> kept = fingerprints_of(calibration.documents);
  const Rows there = connection_->run(
      "SELECT id, revision, tool_version FROM calibration WHERE identity = $1 "
      "ORDER BY revision DESC LIMIT 1",
      {entry.identity});
  if (!there.empty() && !again) {
    return {there.front()[0].text(), false, there.front()[2].text()};
  }
  entry.revision = there.empty() ? 1 : static_cast<int>(there.front()[1].integer()) + 1;
  entry.id = id_of(entry.identity, entry.revision);
  entry.digest = digest_of(entry.id, entry.facts, calibration.quantities, calibration.inputs, kept);
  const std::vector<sql::Value> values = values_of(entry);
  const std::string columns = std::string(entry_columns).substr(sizeof "number," - 1);
  const std::int64_t number =
      connection_
          ->run(fmt::format("INSERT INTO calibration ({}) VALUES ({}) RETURNING number", columns,
                            places(values.size())),
                values)
          .front()
          .front()
          .integer();
  for (std::size_t k = 0; k < calibration.quantities.size(); ++k) {
    const Row row = row_of(calibration.quantities[k], number, k);
    connection_->run(
        "INSERT INTO quantity (calibration, place, name, words, unit, verdict, value, low, high) "
        "VALUES (" +
            places(row.size()) + ")",
        row);
  }
  for (std::size_t k = 0; k < calibration.inputs.size(); ++k) {
    const Row row = row_of(calibration.inputs[k], number, k);
    connection_->run(fmt::format("INSERT INTO input (calibration, place, {}) VALUES ({})",
                                 input_columns, places(row.size())),
                     row);
  }
  for (const calibration::Document& document : calibration.documents)
    add_document(number, document);
  append_event("added", entry.id, entry.digest, now_utc);
  return {entry.id, true, entry.facts.tool_version};
}

bool CalibrationArchive::attach_report(const std::string& id, std::string_view html,
                                       const std::string& now_utc) {
  bool is_attached = false;
  connection_->write([&] {
    const Rows rows = connection_->run(
        "SELECT calibration.number, document.number FROM calibration LEFT JOIN document ON "
        "document.calibration = calibration.number AND document.kind = 'report' WHERE id = $1",
        {id});
    if (rows.empty() || !rows.front()[1].is_null()) return;
    const calibration::Document report{calibration::DocumentKind::report, "", std::string(html)};
    add_document(rows.front()[0].integer(), report);
    append_event("report", id, sha256_hex(html), now_utc);
    is_attached = true;
  });
  return is_attached;
}

void CalibrationArchive::add_document(std::int64_t calibration,
                                      const calibration::Document& document) {
  const std::string stored = compressed(document.bytes);
  StoredDocument fingerprint = fingerprint_of(document);
  fingerprint.stored_bytes = stored.size();
  const Row row = row_of(fingerprint, calibration);
  const std::int64_t number =
      connection_
          ->run(fmt::format("INSERT INTO document (calibration, {}) VALUES ({}) RETURNING number",
                            document_columns, places(row.size())),
                row)
          .front()
          .front()
          .integer();
  connection_->run("INSERT INTO content (document, zstd) VALUES ($1, $2)",
                   {number, sql::Blob{stored}});
}

void CalibrationArchive::append_event(const char* what, const std::string& id,
                                      const std::string& digest, const std::string& now_utc) {
  const Rows last =
      connection_->run("SELECT number, chain FROM event ORDER BY number DESC LIMIT 1");
  const std::string previous = last.empty() ? "" : last.front()[1].text();
  const Event event{last.empty() ? 1 : last.front()[0].integer() + 1, now_utc, what, id, digest};
  connection_->run(
      "INSERT INTO event (number, at_utc, what, id, digest, chain) VALUES (" + places(6) + ")",
      {event.number, event.at_utc, event.what, event.id, event.digest,
       chain_link(previous, event)});
}

void CalibrationArchive::remove(const calibration::Entry& entry, const std::string& now_utc) {
  connection_->write([&] {
    const Rows gone =
        connection_->run("DELETE FROM calibration WHERE id = $1 RETURNING number", {entry.id});
    if (!gone.empty()) append_event("removed", entry.id, entry.digest, now_utc);
  });
}

void CalibrationArchive::backup(const std::string& path) {
  if (connection_->dialect() != sql::Dialect::sqlite) {
    throw UsageError("archive backup copies an SQLite archive; for PostgreSQL use pg_dump");
  }
  sql::copy_sqlite(*connection_, path);
}

}  // namespace tribolog::archive::store
