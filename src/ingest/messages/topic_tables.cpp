#include "ingest/messages/topic_tables.h"

#include <algorithm>
#include <limits>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "base/error.h"
#include "wording/words.h"

namespace tribolog::ingest::messages {

namespace {

/// Two's complement: the difference is right wherever it fits, whatever the sign of the times.
template <class Integer>
log::LogColumn seconds_since_first(const char* name, const std::vector<Integer>& times_ns) {
  constexpr double ns_per_s = 1e9;
  log::LogColumn column{{std::string(name) + " [s]", name, "s"}, {}, 0};
  column.values.reserve(times_ns.size());
  const auto first = static_cast<std::uint64_t>(times_ns.front());
  for (const Integer time_ns : times_ns) {
    const auto since = static_cast<std::int64_t>(static_cast<std::uint64_t>(time_ns) - first);
    column.values.push_back(static_cast<double>(since) / ns_per_s);
  }
  return column;
}

/// Puts the values into these of so many rows, and gaps into the others.
void spread(log::LogColumn& column, const std::vector<std::size_t>& rows, std::size_t all_rows) {
  if (rows.size() == all_rows) return;
  std::vector<double> values(all_rows, std::numeric_limits<double>::quiet_NaN());
  for (std::size_t i = 0; i < rows.size(); ++i) values[rows[i]] = column.values[i];
  column.values = std::move(values);
  column.gaps = all_rows - rows.size();
}

std::size_t times_going_back(const std::vector<std::uint64_t>& times_ns) {
  std::size_t count = 0;
  for (std::size_t i = 1; i < times_ns.size(); ++i) count += times_ns[i] < times_ns[i - 1] ? 1 : 0;
  return count;
}

/// A joint's or field's name may be the same as another's path.
void make_names_differ(std::vector<log::LogColumn>& columns) {
  std::set<std::string> taken;
  for (log::LogColumn& column : columns) {
    while (!taken.insert(column.header.name).second) {
      column.header.name = "message." + column.header.name;
      column.header.full = column.header.name;
    }
  }
}

std::vector<Statement> notes_of(const MessageColumns& columns, const std::string& topic) {
  std::vector<Statement> notes;
  for (const std::string& path : columns.long_arrays()) {
    notes.push_back({"reading.long_array", {{"topic", topic}, {"path", path}}});
  }
  if (columns.has_too_many_columns()) {
    notes.push_back({"reading.too_many_columns", {{"topic", topic}}});
  }
  if (columns.too_long() > 0) {
    notes.push_back(
        {"reading.long_messages",
         {{"topic", topic}, {"longer", columns.too_long()}, {"messages", columns.rows()}}});
  }
  return notes;
}

}  // namespace

void TopicTable::take(std::string_view message, std::uint64_t log_time_ns) {
  if (!refusal_.empty()) return;
  const std::size_t row = log_times_ns_.size();
  try {
    if (const auto stamp_ns = reader_->take_row(message, columns_)) {
      rows_of_stamps_.push_back(row);
      stamps_ns_.push_back(*stamp_ns);
    }
  } catch (const MessageError& error) {
    throw MessageError(
        fmt::format("message {} of {} {}", row + 1, printable(topic_), error.what()));
  }
  log_times_ns_.push_back(log_time_ns);
}

std::optional<log::LogTable> TopicTable::finish(const std::string& file) && {
  log::LogTable table;
  table.file = file;
  table.group = topic_;
  table.rows = columns_.rows();
  columns_.fill_gaps();
  table.notes = notes_of(columns_, printable(topic_));
  table.refusal = refusal_;
  std::vector<log::LogColumn> numbers = std::move(columns_).finish();
  if (numbers.empty() && refusal_.empty()) return std::nullopt;
  if (!stamps_ns_.empty()) {
    table.columns.push_back(seconds_since_first("time", stamps_ns_));
    spread(table.columns.back(), rows_of_stamps_, table.rows);
  }
  if (!log_times_ns_.empty()) {
    table.columns.push_back(seconds_since_first("log_time", log_times_ns_));
  }
  for (log::LogColumn& column : numbers) table.columns.push_back(std::move(column));
  make_names_differ(table.columns);
  for (const log::LogColumn& column : table.columns) table.header.push_back(column.header.full);
  if (const std::size_t back = times_going_back(log_times_ns_); back > 0) {
    table.notes.push_back({"reading.log_time_goes_back",
                           {{"topic", printable(topic_)}, {"back", back}, {"rows", table.rows}}});
  }
  return table;
}

namespace {

Statement without_numbers(const std::string& topic) {
  return {"reading.no_number_in_topic", {{"topic", printable(topic)}}};
}

}  // namespace

TopicTable* TopicTables::table_for(const TopicDescription& topic) {
  const auto [entry, is_new] = table_of_.try_emplace(
      {topic.topic, topic.type, topic.message_encoding, topic.schema_encoding, topic.schema},
      nullptr);
  if (!is_new) return entry->second;
  try {
    entry->second = &tables_.emplace_back(topic.topic, reader_of_(topic));
  } catch (const SchemaError& error) {
    note({"reading.not_read", {{"name", printable(topic.topic)}, {"why", error.what()}}});
  }
  return entry->second;
}

std::vector<log::LogTable> TopicTables::finish() && {
  std::vector<log::LogTable> finished;
  for (TopicTable& table : tables_) {
    const std::string topic = table.topic();
    if (auto made = std::move(table).finish(file_)) {
      finished.push_back(*std::move(made));
    } else {
      note(without_numbers(topic));
    }
  }
  if (finished.empty()) {
    Statement reasons;
    for (const Statement& note : notes_) reasons.add(note);
    throw InputError({file_, 0, 0},
                     {"holds no topic with numbers that can be read", wording::words(reasons),
                      "messages of ROS, JSON or protobuf, such as sensor_msgs/JointState", ""});
  }
  const bool any_whole =
      std::any_of(finished.begin(), finished.end(),
                  [](const log::LogTable& table) { return table.refusal.empty(); });
  if (!any_whole) throw InputError({file_, 0, 0}, {finished.front().refusal, "", "", ""});
  for (log::LogTable& table : finished) {
    table.notes.insert(table.notes.end(), notes_.begin(), notes_.end());
  }
  return finished;
}

}  // namespace tribolog::ingest::messages
