#include "archive/store/schema.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <string>

#include <fmt/format.h>

#include "base/error.h"

namespace tribolog::archive::store {
namespace {

// INT, REAL_, TEXT, BYTES, KEY and STRICT_ are written as each database has them.
constexpr const char* tables = R"(
CREATE TABLE calibration (
  number KEY,
  id TEXT NOT NULL UNIQUE CHECK (length(id) = 64),
  identity TEXT NOT NULL CHECK (length(identity) = 64),
  revision INT NOT NULL CHECK (revision >= 1),
  robot TEXT NOT NULL,
  serial TEXT NOT NULL,
  joint TEXT NOT NULL,
  measured_at TEXT NOT NULL CHECK (length(measured_at) = 20),
  measured_on TEXT NOT NULL,
  time_is_stated INT NOT NULL CHECK (time_is_stated IN (0, 1)),
  created_utc TEXT NOT NULL,
  operator TEXT NOT NULL,
  note TEXT NOT NULL,
  payload TEXT NOT NULL,
  payload_kg REAL_ CHECK (payload_kg >= 0),
  payload_distance_m REAL_ CHECK (payload_distance_m > 0),
  temperature_C REAL_ CHECK (temperature_C > -273.15),
  gear_ratio REAL_ NOT NULL CHECK (gear_ratio <> 0),
  sampling_Hz REAL_ CHECK (sampling_Hz > 0),
  verdict TEXT NOT NULL CHECK (verdict IN ('usable', 'doubtful', 'not_identifiable')),
  sentence TEXT NOT NULL,
  configuration TEXT NOT NULL,
  tool_version TEXT NOT NULL,
  git_revision TEXT NOT NULL,
  digest TEXT NOT NULL CHECK (length(digest) = 64),
  UNIQUE (identity, revision)
) STRICT_;

CREATE TABLE quantity (
  calibration INT NOT NULL REFERENCES calibration (number) ON DELETE CASCADE,
  place INT NOT NULL,
  name TEXT NOT NULL,
  words TEXT NOT NULL,
  unit TEXT NOT NULL,
  verdict TEXT NOT NULL CHECK (verdict IN ('usable', 'doubtful', 'not_identifiable')),
  value REAL_ CHECK (abs(value) <= 1.7976931348623157e308),
  low REAL_ CHECK (low <= value),
  high REAL_ CHECK (high >= value),
  PRIMARY KEY (calibration, place)
) STRICT_;

CREATE TABLE input (
  calibration INT NOT NULL REFERENCES calibration (number) ON DELETE CASCADE,
  place INT NOT NULL,
  name TEXT NOT NULL,
  role TEXT NOT NULL,
  bytes INT NOT NULL CHECK (bytes >= 0),
  sha256 TEXT NOT NULL CHECK (length(sha256) = 64),
  PRIMARY KEY (calibration, place)
) STRICT_;

CREATE TABLE document (
  number KEY,
  calibration INT NOT NULL REFERENCES calibration (number) ON DELETE CASCADE,
  kind TEXT NOT NULL CHECK (kind IN ('calibration', 'report', 'input')),
  name TEXT NOT NULL,
  bytes INT NOT NULL CHECK (bytes >= 0),
  sha256 TEXT NOT NULL CHECK (length(sha256) = 64),
  stored_bytes INT NOT NULL
) STRICT_;
CREATE INDEX document_of_calibration ON document (calibration);
CREATE UNIQUE INDEX one_document_of_a_kind ON document (calibration, kind) WHERE kind <> 'input';

CREATE TABLE content (
  document INT PRIMARY KEY REFERENCES document (number) ON DELETE CASCADE,
  zstd BYTES NOT NULL
) STRICT_;

)";

constexpr const char* event = R"(
CREATE TABLE event (
  number INT PRIMARY KEY CHECK (number >= 1),
  at_utc TEXT NOT NULL,
  what TEXT NOT NULL CHECK (what IN ('added', 'report', 'reviewed', 'removed')),
  id TEXT NOT NULL,
  digest TEXT NOT NULL,
  chain TEXT NOT NULL CHECK (length(chain) = 64)
) STRICT_;
)";

constexpr const char* review = R"(
CREATE TABLE review (
  calibration INT NOT NULL REFERENCES calibration (number) ON DELETE CASCADE,
  place INT NOT NULL,
  at_utc TEXT NOT NULL,
  reviewer TEXT NOT NULL,
  decision TEXT NOT NULL CHECK (decision IN ('approved', 'rejected')),
  note TEXT NOT NULL,
  PRIMARY KEY (calibration, place)
) STRICT_;
)";

constexpr const char* sqlite_index =
    "CREATE INDEX calibration_of_joint ON calibration (robot, serial, joint, measured_at)";

// A tree of the server's takes no text of more than some kB.
constexpr const char* postgres_indices =
    "CREATE INDEX calibration_of_robot ON calibration USING hash (robot);"
    "CREATE INDEX calibration_of_serial ON calibration USING hash (serial)";

std::string replaced(std::string text, const std::string& word, const std::string& by) {
  for (std::size_t at = 0; (at = text.find(word, at)) != std::string::npos; at += by.size()) {
    text.replace(at, word.size(), by);
  }
  return text;
}

/// As the connection's database writes it.
std::string in_dialect(const sql::Connection& connection, std::string script) {
  const bool is_sqlite = connection.dialect() == sql::Dialect::sqlite;
  script = replaced(script, "REAL_", is_sqlite ? "REAL" : "DOUBLE PRECISION");
  script = replaced(script, "STRICT_", is_sqlite ? "STRICT" : "");
  // Texts are told apart by their bytes, not by a locale.
  script = replaced(script, " TEXT ", is_sqlite ? " TEXT " : " TEXT COLLATE \"C\" ");
  script = replaced(script, "BYTES", is_sqlite ? "BLOB" : "BYTEA");
  script = replaced(script, " KEY,",
                    is_sqlite ? " INTEGER PRIMARY KEY AUTOINCREMENT,"
                              : " BIGINT GENERATED ALWAYS AS IDENTITY PRIMARY KEY,");
  return replaced(script, " INT ", is_sqlite ? " INTEGER " : " BIGINT ");
}

}  // namespace

void create_schema(sql::Connection& connection, int version) {
  const bool is_sqlite = connection.dialect() == sql::Dialect::sqlite;
  const bool has_reviews = version >= first_schema_with_reviews;
  connection.run_script(in_dialect(connection, tables));
  connection.run_script(
      in_dialect(connection, has_reviews ? event : replaced(event, "'reviewed', ", "")));
  if (has_reviews) connection.run_script(in_dialect(connection, review));
  connection.run_script(is_sqlite ? sqlite_index : postgres_indices);
  if (!is_sqlite) {
    connection.run_script(
        "CREATE TABLE archive (version BIGINT NOT NULL); INSERT INTO archive VALUES (0)");
  }
  set_version(connection, version);
}

void add_reviews(sql::Connection& connection) {
  connection.run_script("ALTER TABLE event RENAME TO event_of_schema_1");
  connection.run_script(in_dialect(connection, event));
  connection.run_script(in_dialect(connection, review));
  connection.run_script(
      "INSERT INTO event SELECT number, at_utc, what, id, digest, chain FROM event_of_schema_1;"
      "DROP TABLE event_of_schema_1");
}

void take_wider_digests(sql::Connection& /*connection*/) {}

void set_version(sql::Connection& connection, int version) {
  const bool is_sqlite = connection.dialect() == sql::Dialect::sqlite;
  connection.run_script((is_sqlite ? "PRAGMA user_version = " : "UPDATE archive SET version = ") +
                        std::to_string(version));
}

int version_of(sql::Connection& connection) {
  const auto number = [&](const char* statement) {
    const sql::Rows rows = connection.run(statement);
    if (rows.size() != 1) {
      throw ArchiveError(printable(connection.name(), longest_path) +
                         ": the archive's schema is damaged (it has not one version); it is left "
                         "as it is; restore a backup");
    }
    constexpr std::int64_t most = std::numeric_limits<int>::max();
    return static_cast<int>(std::clamp<std::int64_t>(rows.front().front().integer(), -1, most));
  };
  if (connection.dialect() == sql::Dialect::sqlite) return number("PRAGMA user_version");
  const int tables_named_so = number(
      "SELECT count(*) FROM information_schema.tables "
      "WHERE table_schema = current_schema() AND table_name = 'archive'");
  if (tables_named_so == 0) return 0;
  const int version = number("SELECT version FROM archive");
  return version == 0 ? -1 : version;  // its tables are there
}

void refuse_other_versions(sql::Connection& connection, int known) {
  const int version = version_of(connection);
  const std::string name = printable(connection.name(), longest_path);
  if (version > known) {
    throw ArchiveError(
        fmt::format("{}: the archive is of a newer tribolog (schema {}, this program "
                    "knows {}); it is left as it is; update tribolog",
                    name, version, known));
  }
  if (version < 1) {
    throw ArchiveError(name + ": holds no tables of an archive; it is left as it is");
  }
}

}  // namespace tribolog::archive::store
