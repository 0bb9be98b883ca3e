#include "archive/store/calibration_archive.h"

#include <algorithm>
#include <map>
#include <tuple>

#include <fmt/format.h>

#include "archive/sql/sqlite_connection.h"
#include "archive/store/compressed.h"
#include "archive/store/digest.h"
#include "archive/store/entry_rows.h"
#include "archive/store/kept_texts.h"
#include "archive/store/schema.h"

#include "error.h"
#include "files/sha256.h"

namespace tribolog::archive {
namespace {

using sql::Blob;
using sql::Row;
using sql::Rows;
using sql::Value;

std::int64_t whole(std::size_t number) { return static_cast<std::int64_t>(number); }

/// "$1, $2, ..., $n"
std::string places(std::size_t count) {
  std::string text;
  for (std::size_t k = 1; k <= count; ++k) text += fmt::format("{}${}", k == 1 ? "" : ", ", k);
  return text;
}

/// " WHERE robot = $1 ...", and its parameters.
std::pair<std::string, std::vector<Value>> conditions(const Filter& filter) {
  std::string text;
  std::vector<Value> values;
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

auto place_of(const Entry& e) {
  return std::tie(e.facts.of.robot, e.facts.of.serial, e.facts.of.joint, e.facts.measured_at,
                  e.identity, e.revision);
}

DocumentKind kind_of(const std::string& word) {
  for (const DocumentKind kind : {DocumentKind::calibration, DocumentKind::report}) {
    if (to_string(kind) == word) return kind;
  }
  return DocumentKind::input;
}

std::string calibration_sha256(const std::vector<Document>& documents) {
  const auto at = std::find_if(documents.begin(), documents.end(), [](const Document& document) {
    return document.kind == DocumentKind::calibration;
  });
  return at == documents.end() ? "" : sha256_hex(at->bytes);
}

}  // namespace

CalibrationArchive::CalibrationArchive(std::unique_ptr<sql::Connection> connection)
    : connection_(std::move(connection)) {
  refuse_other_versions(*connection_);
}

Added CalibrationArchive::add(const NewCalibration& calibration, bool again,
                              const std::string& now_utc) {
  Entry entry;
  entry.facts = calibration.facts;
  entry.identity = calibration.identity();
  refuse_unkept_texts(calibration);
  const std::string calibration_hash = calibration_sha256(calibration.documents);
  Added added;
  connection_->write([&] {
    const Rows there = connection_->run(
        "SELECT id, revision, tool_version FROM calibration WHERE identity = $1 "
        "ORDER BY revision DESC LIMIT 1",
        {entry.identity});
    if (!there.empty() && !again) {
      added = {there.front()[0].text(), false, there.front()[2].text()};
      return;
    }
    entry.revision = there.empty() ? 1 : static_cast<int>(there.front()[1].integer()) + 1;
    entry.id = id_of(entry.identity, entry.revision);
    entry.digest = digest_of(entry.id, entry.facts, calibration.quantities, calibration.inputs,
                             calibration_hash);
    const std::vector<Value> values = values_of(entry);
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
      const Quantity& q = calibration.quantities[k];
      const auto& e = q.estimate;
      connection_->run(
          "INSERT INTO quantity (calibration, place, name, words, unit, verdict, value, low, high) "
          "VALUES (" +
              places(9) + ")",
          {number, whole(k), q.name, q.words, q.unit, tribolog::to_string(q.verdict),
           e ? Value(e->value) : Value(), e ? Value(e->low) : Value(),
           e ? Value(e->high) : Value()});
    }
    for (std::size_t k = 0; k < calibration.inputs.size(); ++k) {
      const Input& input = calibration.inputs[k];
      connection_->run(
          "INSERT INTO input (calibration, place, name, role, bytes, sha256) VALUES (" + places(6) +
              ")",
          {number, whole(k), input.name, input.role, whole(input.bytes), input.sha256});
    }
    for (const Document& document : calibration.documents) add_document(number, document);
    append_event("added", entry.id, entry.digest, now_utc);
    added = {entry.id, true, entry.facts.tool_version};
  });
  return added;
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
    const Document report{DocumentKind::report, "", std::string(html)};
    add_document(rows.front()[0].integer(), report);
    append_event("report", id, sha256_hex(html), now_utc);
    is_attached = true;
  });
  return is_attached;
}

void CalibrationArchive::add_document(std::int64_t calibration, const Document& document) {
  const std::string stored = compressed(document.bytes);
  const std::int64_t number =
      connection_
          ->run(
              "INSERT INTO document (calibration, kind, name, bytes, sha256, stored_bytes) VALUES "
              "(" +
                  places(6) + ") RETURNING number",
              {calibration, to_string(document.kind), document.name, whole(document.bytes.size()),
               sha256_hex(document.bytes), whole(stored.size())})
          .front()
          .front()
          .integer();
  connection_->run("INSERT INTO content (document, zstd) VALUES ($1, $2)", {number, Blob{stored}});
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

std::vector<Entry> CalibrationArchive::list(const Filter& filter) {
  const auto [where, values] = conditions(filter);
  std::vector<Entry> entries;
  for (const Row& row : connection_->run(
           fmt::format("SELECT {} FROM calibration{}", entry_columns, where), values)) {
    entries.push_back(entry_of(row));
  }
  // Not by the database, whose order of texts depends on its locale.
  std::sort(entries.begin(), entries.end(),
            [](const Entry& a, const Entry& b) { return place_of(a) < place_of(b); });
  return entries;
}

Entry CalibrationArchive::find(const std::string& digits) {
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
                                 rows[0][1].text().substr(0, 2 * shown_digits),
                                 rows[1][1].text().substr(0, 2 * shown_digits)));
  }
  return entry_of(rows.front());
}

std::vector<Quantity> CalibrationArchive::quantities(const Entry& entry) {
  std::vector<Quantity> quantities;
  for (const Row& row :
       connection_->run(fmt::format("SELECT {} FROM quantity WHERE calibration = $1 ORDER BY place",
                                    quantity_columns),
                        {entry.number})) {
    quantities.push_back(quantity_of(row));
  }
  return quantities;
}

std::vector<Input> CalibrationArchive::inputs(const Entry& entry) {
  std::vector<Input> inputs;
  for (const Row& row : connection_->run(
           "SELECT name, role, bytes, sha256 FROM input WHERE calibration = $1 ORDER BY place",
           {entry.number})) {
    inputs.push_back({row[0].text(), row[1].text(), static_cast<std::uint64_t>(row[2].integer()),
                      row[3].text()});
  }
  return inputs;
}

std::vector<StoredDocument> CalibrationArchive::documents(const Entry& entry) {
  std::vector<StoredDocument> documents;
  for (const Row& row : connection_->run(
           "SELECT kind, name, bytes, stored_bytes, sha256 FROM document WHERE calibration = $1 "
           "ORDER BY number",
           {entry.number})) {
    documents.push_back({kind_of(row[0].text()), row[1].text(),
                         static_cast<std::uint64_t>(row[2].integer()),
                         static_cast<std::uint64_t>(row[3].integer()), row[4].text()});
  }
  return documents;
}

std::vector<Measured> CalibrationArchive::measured(const Filter& filter) {
  std::vector<Measured> found;
  connection_->read([&] {
    std::map<std::int64_t, std::size_t> place;
    for (Entry& entry : list(filter)) {
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

std::optional<std::string> CalibrationArchive::document(const Entry& entry, DocumentKind kind,
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
                       " of " + entry.id.substr(0, shown_digits) +
                       " is not what was archived; restore a backup");
  }
  return bytes;
}

void CalibrationArchive::remove(const Entry& entry, const std::string& now_utc) {
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

}  // namespace tribolog::archive
