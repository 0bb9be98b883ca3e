#include "ingest/bags/topic_tables.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "base/error.h"
#include "ingest/bags/known_message_types.h"

namespace tribolog {
namespace {

/// @throw SchemaError: why the topic cannot be read.
MessageSchema schema_of(const TopicDescription& topic) {
  if (topic.message_encoding != "cdr") {
    throw SchemaError("messages are encoded as '" + printable(topic.message_encoding) +
                      "', not as cdr");
  }
  if (topic.schema_encoding == "ros2msg") return parse_ros2msg(topic.type, topic.schema);
  if (const auto known = known_message_type(short_type_name(topic.type))) {
    return parse_ros2msg(topic.type, *known);
  }
  if (topic.schema_encoding.empty()) {
    const std::string what = topic.type.empty() ? "its messages consist" : topic.type + " consists";
    throw SchemaError("the log does not say what " + printable(what) + " of");
  }
  throw SchemaError(printable(topic.type) + " is defined in '" + printable(topic.schema_encoding) +
                    "', not in ros2msg");
}

std::string without_numbers(const std::string& topic) {
  return printable(topic) + " is not read: no message holds a number";
}

}  // namespace

TopicTable* TopicTables::table_for(const TopicDescription& topic) {
  const auto [entry, is_new] = table_of_.try_emplace(
      {topic.topic, topic.type, topic.message_encoding, topic.schema_encoding, topic.schema},
      nullptr);
  if (!is_new) return entry->second;
  try {
    entry->second = &tables_.emplace_back(topic.topic, schema_of(topic));
  } catch (const SchemaError& error) {
    note(printable(topic.topic) + " is not read: " + error.what());
  }
  return entry->second;
}

std::vector<LogTable> TopicTables::finish() && {
  std::vector<LogTable> finished;
  for (TopicTable& table : tables_) {
    const std::string topic = table.topic();
    if (auto made = std::move(table).finish(file_)) {
      finished.push_back(*std::move(made));
    } else {
      note(without_numbers(topic));
    }
  }
  if (finished.empty()) {
    std::string reasons;
    for (const std::string& note : notes_) reasons += (reasons.empty() ? "" : "; ") + note;
    throw InputError({file_, 0, 0},
                     {"holds no topic with numbers that can be read", reasons,
                      "messages of ROS 2 in CDR, such as sensor_msgs/JointState", ""});
  }
  const bool any_whole = std::any_of(finished.begin(), finished.end(),
                                     [](const LogTable& table) { return table.refusal.empty(); });
  if (!any_whole) throw InputError({file_, 0, 0}, {finished.front().refusal, "", "", ""});
  for (LogTable& table : finished) {
    table.notes.insert(table.notes.end(), notes_.begin(), notes_.end());
  }
  return finished;
}

}  // namespace tribolog
