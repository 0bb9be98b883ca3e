#pragma once
// All topics of a log, each with its table or the reason why it has none.

#include <deque>
#include <map>
#include <string>
#include <vector>

#include "ingest/bags/topic_table.h"
#include "ingest/log/log_table.h"

namespace tribolog {

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
  void note(const std::string& text) { notes_.push_back(text); }
  [[nodiscard]] const std::string& file() const { return file_; }

  /// In the order in which the topics occurred; every table with all notes on the whole log.
  /// @throw InputError: no topic holds a number (the notes are its hint), or each has a message
  /// that
  ///        cannot be read.
  std::vector<LogTable> finish() &&;

 private:
  std::string file_;
  std::deque<TopicTable> tables_;
  std::map<std::vector<std::string>, TopicTable*> table_of_;
  std::vector<std::string> notes_;
};

}  // namespace tribolog
