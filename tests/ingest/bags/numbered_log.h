#pragma once
// One MCAP log in all its forms, and what must come out of it.

#include <algorithm>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/temporary_directory.h"
#include "ingest/bags/bag_readers.h"
#include "support/cdr_writer.h"
#include "support/mcap_writer.h"

namespace tribolog::test {

inline constexpr std::int64_t start_ns = 1'700'000'000'123'456'789;
inline constexpr std::size_t message_count = 60;

/// Message i: position i, velocity -i of joint a; 10 for those of b; names turned in every other.
inline JointStateMessage numbered_message(std::size_t i) {
  const auto value = static_cast<double>(i);
  const std::int64_t stamp_ns = start_ns + static_cast<std::int64_t>(i) * 1'000'001;
  if (i % 2 == 0) return {stamp_ns, {"a", "b"}, {value, 10}, {-value, 10}, {}};
  return {stamp_ns, {"b", "a"}, {10, value}, {10, -value}, {}};
}

inline McapWriter writer_with_joints(const McapOptions& options) {
  McapWriter writer(options);
  writer.add_schema(7, "sensor_msgs/msg/JointState", "ros2msg", joint_state_definition);
  writer.add_channel(3, 7, "/joint_states");
  return writer;
}

inline McapWriter numbered_log(const McapOptions& options) {
  McapWriter writer = writer_with_joints(options);
  for (std::size_t i = 0; i < message_count; ++i) {
    const JointStateMessage message = numbered_message(i);
    writer.add_message(3, static_cast<std::uint64_t>(message.stamp_ns) + 7, message.cdr());
  }
  return writer;
}

inline std::string log_of(const std::vector<JointStateMessage>& messages) {
  McapWriter writer = writer_with_joints({});
  for (const JointStateMessage& message : messages) writer.add_message(3, 5, message.cdr());
  return writer.finish();
}

inline std::vector<ingest::log::LogTable> read(const std::string& bytes) {
  return ingest::bags::read_mcap_bytes(bytes, "a.mcap");
}

inline std::string refusal_of(const std::string& bytes) {
  return refusal_of<InputError>([&] { return read(bytes); });
}

inline const ingest::log::LogColumn& column(const ingest::log::LogTable& table,
                                            std::string_view name) {
  const auto found =
      std::find_if(table.columns.begin(), table.columns.end(),
                   [&](const ingest::log::LogColumn& c) { return c.header.name == name; });
  if (found == table.columns.end()) throw std::runtime_error("no column " + std::string(name));
  return *found;
}

/// The table is that of the first `rows` numbered messages, to the last bit.
inline void expect_numbered(const ingest::log::LogTable& table, std::size_t rows) {
  ASSERT_EQ(table.rows, rows);
  for (std::size_t i = 0; i < rows; ++i) {
    const auto value = static_cast<double>(i);
    ASSERT_EQ(column(table, "a.position").values.at(i), value);
    ASSERT_EQ(column(table, "a.velocity").values.at(i), -value);
    ASSERT_EQ(column(table, "b.position").values.at(i), 10);
    ASSERT_EQ(column(table, "time").values.at(i), value * 1'000'001 / 1e9);
    ASSERT_EQ(column(table, "log_time").values.at(i), value * 1'000'001 / 1e9);
  }
}

inline std::vector<McapOptions> all_forms() {
  std::vector<McapOptions> forms = {{0, "", true, true}, {0, "", true, false}};
  for (const char* const compression : {"", "lz4", "zstd"}) {
    for (const bool with_crc : {true, false}) {
      for (const bool with_summary : {true, false}) {
        forms.push_back({7, compression, with_crc, with_summary});
      }
    }
  }
  return forms;
}

inline std::string shown(const McapOptions& form) {
  return (form.messages_per_chunk > 0 ? "chunks " : "flat ") + form.compression +
         (form.with_crc ? " crc" : "") + (form.with_summary ? " summary" : "");
}

}  // namespace tribolog::test
