#pragma once
// The messages of a log as tables: one for each topic, or the reason why it has none.

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/statement.h"
#include "ingest/bags/cdr_reader.h"
#include "ingest/bags/ros2msg_schema.h"
#include "ingest/log/log_table.h"

namespace tribolog::ingest::bags {

// Messages of one type as rows, their numbers as columns.
//
// A column's name is the path of its number: `wrench.force.x`, `dtau_j[0]`. Where a type names the
// elements of its arrays, these names stand instead, so that the order may change from message to
// message: `<joint>.position`, `.velocity`, `.effort` in sensor_msgs/JointState, and
// `<joint>.<interface>` in control_msgs/DynamicJointState. The message's own header gives no column
// but the time of the row. Not read: texts, and arrays without names of more than 64 elements
// (images, point clouds).

class MessageColumns {
 public:
  explicit MessageColumns(MessageSchema schema);
  MessageColumns(const MessageColumns&) = delete;
  MessageColumns& operator=(const MessageColumns&) = delete;
  ~MessageColumns();

  /// Reads one message as the next row. @return header.stamp in ns, where there is a header.
  /// @throw CdrError: it ends too early, an array has neither no elements nor as many as there are
  ///        names, or a name stands there twice. What was read of this row is then undefined.
  std::optional<std::int64_t> take_row(CdrReader& message);

  [[nodiscard]] std::size_t rows() const { return rows_; }
  /// Messages that are longer than their type says.
  [[nodiscard]] std::size_t too_long() const { return too_long_; }
  /// Paths of arrays that were left out for their length, and whether there were too many columns.
  [[nodiscard]] const std::vector<std::string>& long_arrays() const { return long_arrays_; }
  [[nodiscard]] bool has_too_many_columns() const { return has_too_many_columns_; }

  /// All columns, each with as many values as there are rows, in the order in which they occurred.
  std::vector<log::LogColumn> finish() &&;

 private:
  /// What is known of one place in the message's tree. Places appear as messages need them.
  struct Place;
  using Names = std::vector<std::string_view>;

  std::optional<std::int64_t> take_stamp(CdrReader& message, const MessageType& type);
  void take_fields(CdrReader& message, const MessageType& type, std::size_t first, Place* place);
  void take_field(CdrReader& message, const MessageField& field, Place* place);
  void take_elements(CdrReader& message, const MessageField& field, std::size_t count,
                     Place* place);
  void take_named(CdrReader& message, const MessageField& field, std::size_t count,
                  const Names& names, bool with_field, Place* parent, Place* place);
  Names take_names(CdrReader& message);
  void put(Place* place, double value);
  Place* field_of(Place* parent, std::size_t index, const MessageField& field);
  Place* element_of(Place* parent, std::size_t index);
  Place* added(std::unique_ptr<Place>& where, std::string path);

  MessageSchema schema_;
  std::unique_ptr<Place> root_;
  std::size_t places_{0};
  std::vector<log::LogColumn> columns_;
  std::vector<std::string> long_arrays_;
  bool has_too_many_columns_{false};
  std::size_t rows_{0};
  std::size_t too_long_{0};
};

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
