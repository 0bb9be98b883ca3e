#include "ingest/bags/rosbag_reader.h"

#include <filesystem>
#include <map>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "base/error.h"
#include "ingest/bags/byte_reader.h"
#include "ingest/bags/sqlite_database.h"
#include "ingest/bags/topic_tables.h"

namespace tribolog {
namespace {

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

std::map<std::int64_t, TopicDescription> topics_in(SqliteDatabase& database) {
  const std::map<std::string, Definition> definitions = definitions_in(database);
  std::map<std::int64_t, TopicDescription> topics;
  SqliteRows rows(database, "SELECT id, name, type, serialization_format FROM topics");
  while (rows.next()) {
    TopicDescription topic{rows.text(1), rows.text(2), rows.text(3), "", ""};
    if (const auto known = definitions.find(topic.type); known != definitions.end()) {
      topic.schema_encoding = known->second.encoding;
      topic.schema = known->second.text;
    }
    topics.emplace(rows.integer(0), std::move(topic));
  }
  return topics;
}

void take_messages(SqliteDatabase& database, TopicTables& tables) {
  const std::map<std::int64_t, TopicDescription> topics = topics_in(database);
  std::map<std::int64_t, TopicTable*> table_of;
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
    } catch (const CdrError& error) {
      entry->second->refuse(fmt::format("{} (row {} of messages)", error.what(), rows.integer(0)));
    }
  }
  if (without_topic > 0) {
    tables.note(
        fmt::format("messages left out because they belong to no topic: {}", without_topic));
  }
}

void note_files_beside(const std::string& path, TopicTables& tables) {
  for (const char* const ending : {"-wal", "-journal"}) {
    std::error_code none;
    const auto bytes = std::filesystem::file_size(path + ending, none);
    if (none || bytes == 0) continue;
    tables.note(
        fmt::format("the recording was not closed: what stands in {}{} ({} bytes) is not "
                    "read; sqlite3 can join it to the log",
                    printable(path, 400), ending, bytes));
  }
}

}  // namespace

std::vector<LogTable> read_rosbag_db3(const std::string& path) {
  check_start(path);
  TopicTables tables(path);
  SqliteDatabase database(path);
  take_messages(database, tables);
  note_files_beside(path, tables);
  return std::move(tables).finish();
}

}  // namespace tribolog
