#pragma once
// All topics of a log, each with its table or the reason why it has none.

#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/statement.h"
#include "ingest/bags/message_columns.h"
#include "ingest/log/log_table.h"

namespace tribolog::ingest::bags {

class TopicTable {
 public:
  TopicTable(std::string topic, MessageSchema schema)
      : topic_(std::move(topic)), columns_(std::move(schema)) {}

  [[nodiscard]] const std::string& topic() const { return topic_; }

  /// Reads one message (CDR) as the next row; nothing once a message was refused.
  /// @throw CdrError as MessageColumns::take_row, with the topic and the message's number from 1.
  void take(std::string_view message, std::uint64_t log_time_ns);

  /// A message could not be read, and why: the table keeps the rows before it, and says so.
  void refuse(const std::string& reason) { refusal_ = reason; }

  /// The columns: `time` (header.stamp, where messages have a header) and `log_time`, both in
  /// seconds since the topic's first, formed from differences in whole nanoseconds; then those of
  /// MessageColumns. A field that is called `time` itself is `message.time`.
  /// @param file for messages. @return nothing where no message holds a number to read.
  std::optional<log::LogTable> finish(const std::string& file) &&;

 private:
  std::string topic_;
  MessageColumns columns_;
  std::string refusal_;
  std::vector<std::int64_t> stamps_ns_;  ///< Empty: messages have no header.
  std::vector<std::uint64_t> log_times_ns_;
};

/// A topic as the log describes it.
struct TopicDescription {
  std::string topic;
  std::string type;              ///< "sensor_msgs/msg/JointState"
  std::string message_encoding;  ///< "cdr"
  std::string schema_encoding;   ///< "ros2msg"; empty: the log does not define the type.
  std::string schema;
};

class TopicTables {
 public:
  explicit TopicTables(std::string file) : file_(std::move(file)) {}

  /// Where the messages of a topic go; channels of the same topic and type share a table.
  /// @return nullptr where they are not read; a note says why.
  TopicTable* table_for(const TopicDescription& description);
  /// Something that the user should know of the whole log.
  void note(const Statement& note) { notes_.push_back(note); }
  [[nodiscard]] const std::string& file() const { return file_; }

  /// In the order in which the topics occurred; every table with all notes on the whole log.
  /// @throw InputError: no topic holds a number (the notes are its hint), or each has a message
  /// that
  ///        cannot be read.
  std::vector<log::LogTable> finish() &&;

 private:
  std::string file_;
  std::deque<TopicTable> tables_;
  std::map<std::vector<std::string>, TopicTable*> table_of_;
  std::vector<Statement> notes_;
};

}  // namespace tribolog::ingest::bags
