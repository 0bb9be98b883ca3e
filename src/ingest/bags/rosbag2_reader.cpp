#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <sqlite3.h>

#include "base/error.h"
#include "ingest/bags/bag_readers.h"
#include "ingest/bags/byte_reader.h"
#include "ingest/bags/message_readers.h"
#include "ingest/messages/topic_tables.h"

struct sqlite3;
struct sqlite3_stmt;

namespace tribolog::ingest::bags {

// An SQLite file that is only read, behind a plain interface.

namespace {

/// Owner of an open database. Nothing is written, no lock is taken, and no file beside it is read.
class SqliteDatabase {
 public:
  /// @throw InputError naming the file: it cannot be opened, or is damaged.
  explicit SqliteDatabase(const std::string& path);

  [[nodiscard]] bool has_table(const std::string& name);
  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  friend class SqliteRows;
  [[noreturn]] void refuse() const;

  struct Close {
    void operator()(sqlite3* database) const;
  };
  std::string path_;
  std::unique_ptr<sqlite3, Close> database_;
};

/// The rows that a query gives, one after the other. Columns count from 0.
class SqliteRows {
 public:
  /// @throw InputError: the database is damaged or lacks what the query asks for.
  SqliteRows(SqliteDatabase& database, const std::string& query);

  /// @return false after the last row. @throw InputError: the database is damaged.
  bool next();
  [[nodiscard]] std::int64_t integer(int column);
  [[nodiscard]] std::string text(int column);
  /// Valid until the next call of next().
  [[nodiscard]] std::string_view blob(int column);

 private:
  struct Finalize {
    void operator()(sqlite3_stmt* statement) const;
  };
  SqliteDatabase& database_;
  std::unique_ptr<sqlite3_stmt, Finalize> statement_;
};

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

using namespace std::string_view_literals;

void check_start(const std::string& path) {
  constexpr std::string_view sqlite_start = "SQLite format 3\0"sv;
  constexpr std::string_view zstd_start = "\x28\xb5\x2f\xfd"sv;
  InputFileSource file(path);
  ByteReader source(file);
  std::string start;
  (void)source.append(start, sqlite_start.size());
  if (start == sqlite_start) return;
  if (start.empty()) throw InputError({path, 0, 0}, {"file is empty", "", "", ""});
  if (start.starts_with(zstd_start)) {
    throw InputError({path, 0, 0}, {"is packed with zstd (byte 0)", "", "an SQLite database",
                                    "unpack it: zstd -d " + path});
  }
  throw InputError({path, 0, 0}, {"is not an SQLite database (byte 0)", "'" + start + "'",
                                  "'SQLite format 3'", ""});
}

struct Definition {
  std::string encoding;
  std::string text;
};

std::map<std::string, Definition> definitions_in(SqliteDatabase& database) {
  std::map<std::string, Definition> definitions;
  if (!database.has_table("message_definitions")) return definitions;
  SqliteRows rows(database,
                  "SELECT topic_type, encoding, encoded_message_definition "
                  "FROM message_definitions");
  while (rows.next()) {
    if (!rows.text(2).empty()) definitions[rows.text(0)] = {rows.text(1), rows.text(2)};
  }
  return definitions;
}

std::map<std::int64_t, messages::TopicDescription> topics_in(SqliteDatabase& database) {
  const std::map<std::string, Definition> definitions = definitions_in(database);
  std::map<std::int64_t, messages::TopicDescription> topics;
  SqliteRows rows(database, "SELECT id, name, type, serialization_format FROM topics");
  while (rows.next()) {
    messages::TopicDescription topic{rows.text(1), rows.text(2), rows.text(3), "", ""};
    if (const auto known = definitions.find(topic.type); known != definitions.end()) {
      topic.schema_encoding = known->second.encoding;
      topic.schema = known->second.text;
    }
    topics.emplace(rows.integer(0), std::move(topic));
  }
  return topics;
}

void take_messages(SqliteDatabase& database, messages::TopicTables& tables) {
  const std::map<std::int64_t, messages::TopicDescription> topics = topics_in(database);
  std::map<std::int64_t, messages::TopicTable*> table_of;
  std::size_t without_topic = 0;
  SqliteRows rows(database, "SELECT id, topic_id, timestamp, data FROM messages ORDER BY id");
  while (rows.next()) {
    const auto topic = topics.find(rows.integer(1));
    if (topic == topics.end()) {
      ++without_topic;
      continue;
    }
    const auto [entry, is_new] = table_of.try_emplace(topic->first, nullptr);
    if (is_new) entry->second = tables.table_for(topic->second);
    if (entry->second == nullptr) continue;
    try {
      entry->second->take(rows.blob(3), static_cast<std::uint64_t>(rows.integer(2)));
    } catch (const messages::MessageError& error) {
      entry->second->refuse(fmt::format("{} (row {} of messages)", error.what(), rows.integer(0)));
    }
  }
  if (without_topic > 0) {
    tables.note({"reading.messages_without_topic", {{"messages", without_topic}}});
  }
}

void note_files_beside(const std::string& path, messages::TopicTables& tables) {
  for (const char* const ending : {"-wal", "-journal"}) {
    std::error_code none;
    const auto bytes = std::filesystem::file_size(path + ending, none);
    if (none || bytes == 0) continue;
    tables.note(
        {"reading.not_closed", {{"file", printable(path, 400) + ending}, {"bytes", bytes}}});
  }
}

}  // namespace

std::vector<log::LogTable> read_rosbag_db3(const std::string& path) {
  check_start(path);
  messages::TopicTables tables(path, reader_of);
  SqliteDatabase database(path);
  take_messages(database, tables);
  note_files_beside(path, tables);
  return std::move(tables).finish();
}

}  // namespace tribolog::ingest::bags
