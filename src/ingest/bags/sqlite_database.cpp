#include "ingest/bags/sqlite_database.h"

#include <fmt/format.h>
#include <sqlite3.h>

#include "base/error.h"

namespace tribolog {
namespace {

constexpr int longest_value_bytes = 1 << 30;

/// The path as a URI: everything but letters, digits and a few signs as %XX.
std::string uri_of(const std::string& path) {
  std::string uri = "file:";
  for (const char byte : path) {
    const bool is_plain = (byte >= 'a' && byte <= 'z') || (byte >= 'A' && byte <= 'Z') ||
                          (byte >= '0' && byte <= '9') || byte == '/' || byte == '.' ||
                          byte == '-' || byte == '_';
    uri += is_plain
               ? std::string(1, byte)
               : fmt::format("%{:02X}", static_cast<unsigned>(static_cast<unsigned char>(byte)));
  }
  return uri + "?mode=ro&immutable=1";
}

}  // namespace

void SqliteDatabase::Close::operator()(sqlite3* database) const { sqlite3_close_v2(database); }

SqliteDatabase::SqliteDatabase(const std::string& path) : path_(path) {
  sqlite3* opened = nullptr;
  const int status =
      sqlite3_open_v2(uri_of(path).c_str(), &opened,
                      SQLITE_OPEN_READONLY | SQLITE_OPEN_URI | SQLITE_OPEN_NOMUTEX, nullptr);
  database_.reset(opened);
  if (status != SQLITE_OK) refuse();
  // The file is a stranger's: no functions from its schema, no values without bound.
  sqlite3_db_config(opened, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
  sqlite3_db_config(opened, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
  sqlite3_limit(opened, SQLITE_LIMIT_LENGTH, longest_value_bytes);
}

void SqliteDatabase::refuse() const {
  const int status = sqlite3_errcode(database_.get());
  const bool is_damaged = status == SQLITE_CORRUPT || status == SQLITE_NOTADB;
  throw InputError({path_, 0, 0},
                   {is_damaged ? "the SQLite database is damaged" : "cannot read as a rosbag2 log",
                    sqlite3_errmsg(database_.get()), "",
                    is_damaged ? "sqlite3 " + path_ + " .recover | sqlite3 recovered.db3" : ""});
}

bool SqliteDatabase::has_table(const std::string& name) {
  SqliteRows rows(*this, "SELECT name FROM sqlite_master WHERE type = 'table'");
  while (rows.next()) {
    if (rows.text(0) == name) return true;
  }
  return false;
}

void SqliteRows::Finalize::operator()(sqlite3_stmt* statement) const {
  sqlite3_finalize(statement);
}

SqliteRows::SqliteRows(SqliteDatabase& database, const std::string& query) : database_(database) {
  sqlite3_stmt* prepared = nullptr;
  const int status =
      sqlite3_prepare_v2(database.database_.get(), query.c_str(), -1, &prepared, nullptr);
  statement_.reset(prepared);
  if (status != SQLITE_OK) database.refuse();
}

bool SqliteRows::next() {
  const int status = sqlite3_step(statement_.get());
  if (status == SQLITE_ROW) return true;
  if (status != SQLITE_DONE) database_.refuse();
  return false;
}

std::int64_t SqliteRows::integer(int column) {
  return sqlite3_column_int64(statement_.get(), column);
}

std::string SqliteRows::text(int column) { return std::string(blob(column)); }

std::string_view SqliteRows::blob(int column) {
  const void* bytes = sqlite3_column_blob(statement_.get(), column);
  if (bytes == nullptr) return {};
  return {static_cast<const char*>(bytes),
          static_cast<std::size_t>(sqlite3_column_bytes(statement_.get(), column))};
}

}  // namespace tribolog
