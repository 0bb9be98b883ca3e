#pragma once
// The messages of one topic as a table.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ingest/bags/message_columns.h"
#include "ingest/log/log_table.h"

namespace tribolog {

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
  std::optional<LogTable> finish(const std::string& file) &&;

 private:
  std::string topic_;
  MessageColumns columns_;
  std::string refusal_;
  std::vector<std::int64_t> stamps_ns_;  ///< Empty: messages have no header.
  std::vector<std::uint64_t> log_times_ns_;
};

}  // namespace tribolog
