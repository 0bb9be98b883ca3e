#pragma once
// The messages of a log as tables: one for each topic, or the reason why it has none.

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "base/statement.h"
#include "ingest/log/log_table.h"
#include "ingest/messages/message_columns.h"

namespace tribolog::ingest::messages {

class TopicTable {
 public:
  TopicTable(std::string topic, std::unique_ptr<MessageReader> reader)
      : topic_(std::move(topic)), reader_(std::move(reader)) {}

  [[nodiscard]] const std::string& topic() const { return topic_; }

  /// Reads one message as the next row; nothing once a message was refused.
  /// @throw MessageError as the topic's reader, with the topic and the message's number from 1.
  void take(std::string_view message, std::uint64_t log_time_ns);

  /// A message could not be read, and why: the table keeps the rows before it, and says so.
  void refuse(const std::string& reason) {
    refusal_ = reason;
    reader_.reset();
  }

  /// The columns: `time` (the messages' own, where they have one; a gap where one has none) and
  /// `log_time`, both in seconds since the topic's first, formed from differences in whole
  /// nanoseconds; then those of MessageColumns. A field that is called `time` itself is
  /// `message.time`.
  /// @param file for messages. @return nothing where no message holds a number to read.
  std::optional<log::LogTable> finish(const std::string& file) &&;

 private:
  std::string topic_;
  std::unique_ptr<MessageReader> reader_;
  MessageColumns columns_;
  std::string refusal_;
  std::vector<std::int64_t> stamps_ns_;      ///< Empty: no message has one.
  std::vector<std::size_t> rows_of_stamps_;  ///< As many.
  std::vector<std::uint64_t> log_times_ns_;
};

/// A topic as the log describes it.
struct TopicDescription {
  std::string topic;
  std::string type;              ///< "sensor_msgs/msg/JointState"
  std::string message_encoding;  ///< "cdr", "ros1", "json", "protobuf"
  std::string schema_encoding;   ///< "ros2msg"; empty: the log does not define the type.
  std::string schema;
};

/// Why the messages of a topic cannot be read: a definition that is not understood, and where in
/// it.
class SchemaError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// What reads the messages of a topic. @throw SchemaError.
using ReaderOfTopic = std::unique_ptr<MessageReader> (*)(const TopicDescription& topic);

class TopicTables {
 public:
  TopicTables(std::string file, ReaderOfTopic reader_of)
      : file_(std::move(file)), reader_of_(reader_of) {}

  /// Where the messages of a topic go; channels of the same topic and type share a table.
  /// @return nullptr where they are not read; a note says why.
  TopicTable* table_for(const TopicDescription& description);
  /// Something that the user should know of the whole log.
  void note(const Statement& note) { notes_.push_back(note); }
  [[nodiscard]] const std::string& file() const { return file_; }

  /// In the order in which the topics occurred; every table with all notes on the whole log.
  /// @throw InputError: no topic holds a number (the notes are its hint), or each has a message
  ///        that cannot be read.
  std::vector<log::LogTable> finish() &&;

 private:
  std::string file_;
  ReaderOfTopic reader_of_;
  std::deque<TopicTable> tables_;
  std::map<std::vector<std::string>, TopicTable*> table_of_;
  std::vector<Statement> notes_;
};

}  // namespace tribolog::ingest::messages
