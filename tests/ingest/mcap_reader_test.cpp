// MCAP logs: what is read, what is left out, and what is refused.

#include "ingest/mcap_reader.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "error.h"
#include "files/temporary_directory.h"
#include "support/cdr_writer.h"
#include "support/mcap_writer.h"

namespace tribolog {
namespace {

using test::CdrWriter;
using test::joint_state_definition;
using test::JointStateMessage;
using test::McapOptions;
using test::McapWriter;
using Values = std::vector<double>;
using Names = std::vector<std::string>;

constexpr std::int64_t start_ns = 1'700'000'000'123'456'789;
constexpr std::size_t message_count = 60;

/// Message i: position i, velocity -i of joint a; 10 for those of b; names turned in every other.
JointStateMessage numbered_message(std::size_t i) {
  const auto value = static_cast<double>(i);
  const std::int64_t stamp_ns = start_ns + static_cast<std::int64_t>(i) * 1'000'001;
  if (i % 2 == 0) return {stamp_ns, {"a", "b"}, {value, 10}, {-value, 10}, {}};
  return {stamp_ns, {"b", "a"}, {10, value}, {10, -value}, {}};
}

McapWriter writer_with_joints(const McapOptions& options) {
  McapWriter writer(options);
  writer.add_schema(7, "sensor_msgs/msg/JointState", "ros2msg", joint_state_definition);
  writer.add_channel(3, 7, "/joint_states");
  return writer;
}

McapWriter numbered_log(const McapOptions& options) {
  McapWriter writer = writer_with_joints(options);
  for (std::size_t i = 0; i < message_count; ++i) {
    const JointStateMessage message = numbered_message(i);
    writer.add_message(3, static_cast<std::uint64_t>(message.stamp_ns) + 7, message.cdr());
  }
  return writer;
}

std::string log_of(const std::vector<JointStateMessage>& messages) {
  McapWriter writer = writer_with_joints({});
  for (const JointStateMessage& message : messages) writer.add_message(3, 5, message.cdr());
  return writer.finish();
}

std::vector<LogTable> read(const std::string& bytes) { return read_mcap_bytes(bytes, "a.mcap"); }

std::string refusal_of(const std::string& bytes) {
  return test::refusal_of<InputError>([&] { return read(bytes); });
}

const LogColumn& column(const LogTable& table, const std::string& name) {
  const auto found = std::find_if(table.columns.begin(), table.columns.end(),
                                  [&](const LogColumn& c) { return c.header.name == name; });
  if (found == table.columns.end()) throw std::runtime_error("no column " + name);
  return *found;
}

/// The table is that of the first `rows` numbered messages, to the last bit.
void expect_numbered(const LogTable& table, std::size_t rows) {
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

std::vector<McapOptions> all_forms() {
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

std::string shown(const McapOptions& form) {
  return (form.messages_per_chunk > 0 ? "chunks " : "flat ") + form.compression +
         (form.with_crc ? " crc" : "") + (form.with_summary ? " summary" : "");
}

TEST(McapReader, ReadsChunkedAndFlatWithEveryCompressionIndexedOrNot) {
  for (const McapOptions& form : all_forms()) {
    SCOPED_TRACE(shown(form));
    const std::vector<LogTable> tables = read(numbered_log(form).finish());
    ASSERT_EQ(tables.size(), 1U);
    EXPECT_EQ(tables[0].group, "/joint_states");
    EXPECT_EQ(tables[0].notes, Names{});
    expect_numbered(tables[0], message_count);
  }
}

TEST(McapReader, ReadsTheSameFromAFile) {
  const test::TemporaryDirectory directory;
  const std::string path =
      directory.file("a log.mcap", numbered_log({7, "zstd", true, true}).finish());
  const std::vector<LogTable> tables = read_mcap(path);
  EXPECT_EQ(tables.at(0).file, path);
  expect_numbered(tables.at(0), message_count);
  EXPECT_EQ(test::refusal_of<InputError>([&] { return read_mcap(directory.path()); }),
            directory.path() + ": cannot read: is a directory");
}

TEST(McapReader, ReadsAllMessagesBeforeTheCutAndInventsNone) {
  std::mt19937 random(5);
  std::size_t cut_positions = 0;
  for (const McapOptions& form : all_forms()) {
    McapWriter log = numbered_log(form);
    const std::string bytes = log.finish();
    for (int trial = 0; trial < 1000; ++trial) {
      const std::size_t cut = random() % bytes.size();
      const auto complete = static_cast<std::size_t>(
          std::count_if(log.readable_from().begin(), log.readable_from().end(),
                        [&](std::size_t end) { return end <= cut; }));
      SCOPED_TRACE(shown(form) + ", cut at byte " + std::to_string(cut));
      ++cut_positions;
      std::vector<LogTable> tables;
      try {
        tables = read(bytes.substr(0, cut));
      } catch (const InputError& error) {
        ASSERT_EQ(complete, 0U) << error.what();
        continue;
      }
      ASSERT_EQ(tables.size(), 1U);
      // A compressed chunk may give some of its messages though its end is missing.
      ASSERT_GE(tables[0].rows, complete);
      ASSERT_LT(tables[0].rows, complete + (form.compression.empty() ? 1 : 8));
      expect_numbered(tables[0], tables[0].rows);
      ASSERT_EQ(tables[0].notes.size(), 1U);
    }
  }
  EXPECT_EQ(cut_positions, 14000U);
}

TEST(McapReader, SaysWhereTheFileIsCut) {
  McapWriter log = numbered_log({});
  const std::string bytes = log.finish();
  const std::size_t end = log.readable_from().at(9);
  const std::string byte = std::to_string(end);
  const std::string length = std::to_string(log.readable_from().at(10) - end - 9);
  const auto notes = [&](std::size_t bytes_kept) {
    return read(bytes.substr(0, bytes_kept)).at(0).notes;
  };
  EXPECT_EQ(notes(end),
            Names{"ends at byte " + byte + " without a footer: the recording was not closed"});
  EXPECT_EQ(notes(end + 4), Names{"truncated in the start of a record at byte " + byte +
                                  ": expected 9 bytes, ended after 4"});
  EXPECT_EQ(notes(end + 19), Names{"truncated in message (0x05) at byte " + byte + ": expected " +
                                   length + " bytes, ended after 10"});
  EXPECT_EQ(notes(bytes.size() - 3).at(0).substr(0, 16), "damaged at byte ");
  EXPECT_EQ(read(bytes + "more").at(0).notes,
            Names{"4 bytes after the log's end at byte " + std::to_string(bytes.size()) +
                  " are not read"});
}

TEST(McapReader, ChangedBytesNeverCrashIt) {
  std::mt19937 random(11);
  std::size_t read_all = 0;
  std::size_t trials = 0;
  for (const McapOptions& form : all_forms()) {
    const std::string bytes = numbered_log(form).finish();
    for (int trial = 0; trial < 500; ++trial, ++trials) {
      std::string changed = bytes;
      changed[random() % bytes.size()] ^= static_cast<char>(1 + random() % 255);
      try {
        const std::vector<LogTable> tables = read(changed);
        read_all += tables.size() == 1 && tables[0].rows == message_count ? 1 : 0;
      } catch (const InputError& error) {
        ASSERT_EQ(std::string(error.what()).find('\n'), std::string::npos);
      }
    }
  }
  EXPECT_GT(read_all, 0U);
  EXPECT_LT(read_all, trials);
}

TEST(McapReader, LeavesOutAChunkWhoseCrcDisagrees) {
  McapWriter log = numbered_log({10, "", true, true});
  std::string bytes = log.finish();
  bytes[log.readable_from().at(25) - 1] ^= 1;  // in the effort of a message of the third chunk
  const LogTable table = read(bytes).at(0);
  EXPECT_EQ(table.rows, message_count - 10);
  EXPECT_EQ(column(table, "a.position").values.at(20), 30);
  ASSERT_EQ(table.notes.size(), 1U);
  EXPECT_NE(table.notes[0].find("is left out: its CRC is "), std::string::npos) << table.notes[0];
}

TEST(McapReader, MatchesJointsByNameAndCountsGaps) {
  const LogTable table = read(log_of({{0, {"a", "b"}, {1, 2}, {}, {5, 6}},
                                      {1, {"b", "c"}, {3, 4}, {}, {}},
                                      {2, {}, {}, {}, {}},
                                      {3, {"c", "b", "a"}, {7, 8, 9}, {}, {1, 2, 3}}}))
                             .at(0);
  EXPECT_EQ(table.header, (Names{"time [s]", "log_time [s]", "a.position", "b.position", "a.effort",
                                 "b.effort", "c.position", "c.effort"}));
  const LogColumn& a = column(table, "a.position");
  EXPECT_EQ(a.gaps, 2U);
  EXPECT_EQ(a.values.at(0), 1);
  EXPECT_TRUE(std::isnan(a.values.at(1)));
  EXPECT_TRUE(std::isnan(a.values.at(2)));
  EXPECT_EQ(a.values.at(3), 9);
  EXPECT_EQ(column(table, "b.effort").gaps, 2U);
  EXPECT_EQ(column(table, "b.effort").values.at(3), 2);
  EXPECT_EQ(column(table, "c.position").values.at(3), 7);
}

TEST(McapReader, KeepsOddNames) {
  const std::string spaced = "arm 1/joint.2 [x]";
  const std::string odd = std::string("\xc3\xa9\n\x01") + '\0' + "z";
  const LogTable table = read(log_of({{0, {spaced, "", odd}, {1, 2, 3}, {}, {}}})).at(0);
  EXPECT_EQ(column(table, spaced + ".position").values, Values{1});
  EXPECT_EQ(column(table, odd + ".position").values, Values{3});
}

TEST(McapReader, RefusesArraysOfAnotherLengthWithMessageAndByte) {
  McapWriter writer = writer_with_joints({});
  writer.add_message(3, 0, JointStateMessage{0, {"a"}, {1}, {}, {}}.cdr());
  const std::size_t byte = writer.readable_from().at(0);
  writer.add_message(3, 0, JointStateMessage{0, {"a", "b"}, {1, 2}, {1, 2, 3}, {}}.cdr());
  EXPECT_EQ(
      refusal_of(writer.finish()),
      "a.mcap: message 2 of /joint_states has 3 elements in velocity, where 2 have a name (byte " +
          std::to_string(byte) + ")");
  EXPECT_NE(refusal_of(log_of({{0, {"a", "a"}, {1, 2}, {}, {}}})).find("names 'a' twice"),
            std::string::npos);
}

TEST(McapReader, KeepsNanosecondsOfLargeTimes) {
  const std::int64_t late_ns = 2'147'483'647'000'000'000;
  const LogTable table =
      read(log_of({{late_ns, {"a"}, {1}, {}, {}}, {late_ns + 1, {"a"}, {1}, {}, {}}})).at(0);
  EXPECT_EQ(column(table, "time").values, (Values{0, 1e-9}));
}

TEST(McapReader, NamesTopicsThatItDoesNotRead) {
  McapWriter writer = writer_with_joints({});
  writer.add_schema(8, "pkg/msg/Idl", "ros2idl", "struct Idl {};");
  writer.add_schema(9, "pkg/msg/Broken", "ros2msg", "Missing field\n");
  writer.add_channel(10, 0, "/json", "json");
  writer.add_channel(11, 8, "/idl");
  writer.add_channel(12, 9, "/broken");
  writer.add_channel(13, 0, "/bare");
  writer.add_channel(14, 9, "/silent");
  for (const std::uint16_t channel : {10, 11, 12, 13, 99}) writer.add_message(channel, 0, "{}");
  writer.add_message(3, 0, numbered_message(0).cdr());
  const std::vector<LogTable> tables = read(writer.finish());
  ASSERT_EQ(tables.size(), 1U);
  EXPECT_EQ(tables[0].notes,
            (Names{"/json is not read: messages are encoded as 'json', not as cdr",
                   "/idl is not read: pkg/msg/Idl is defined in 'ros2idl', not in ros2msg",
                   "/broken is not read: type 'pkg/Missing' is not defined",
                   "/bare is not read: the log does not say what its messages consist of",
                   "messages left out because no channel record stands before them: 1"}));
}

TEST(McapReader, JoinsChannelsOfOneTopicAndSeparatesTopics) {
  McapWriter writer = writer_with_joints({4, "lz4", true, true});
  writer.add_channel(4, 7, "/joint_states");
  writer.add_channel(5, 7, "/other");
  for (std::size_t i = 0; i < 9; ++i) {
    writer.add_message(static_cast<std::uint16_t>(3 + i % 3), i, numbered_message(i).cdr());
  }
  const std::vector<LogTable> tables = read(writer.finish());
  ASSERT_EQ(tables.size(), 2U);
  EXPECT_EQ(tables[0].rows, 6U);
  EXPECT_EQ(column(tables[0], "a.position").values, (Values{0, 1, 3, 4, 6, 7}));
  EXPECT_EQ(column(tables[1], "a.position").values, (Values{2, 5, 8}));
}

TEST(McapReader, SkipsAttachmentsAndUnknownRecords) {
  McapWriter writer = writer_with_joints({3, "zstd", true, true});
  writer.add_message(3, 0, numbered_message(0).cdr());
  writer.add_record(0x09, std::string(300'000, 'x'));
  writer.add_record(0x83, "of another program");
  writer.add_message(3, 1, numbered_message(1).cdr());
  EXPECT_EQ(column(read(writer.finish()).at(0), "a.position").values, (Values{0, 1}));
}

TEST(McapReader, TrustsNoLength) {
  const std::string head = numbered_log({}).finish().substr(0, 8);
  const std::string endless(8, '\x7f');
  for (char opcode = 1; opcode < 16; ++opcode) {
    const std::string refusal = refusal_of(head + opcode + endless);
    EXPECT_NE(refusal.find("holds no topic with numbers"), std::string::npos) << refusal;
  }
  // 64 MiB of zeros in 6 kB of zstd, where 1 MiB is allowed.
  const std::string zeros(std::size_t{64} << 20, '\0');
  McapWriter bomb = writer_with_joints({1, "zstd", false, false});
  bomb.add_message(3, 0, zeros);
  const std::string bytes = bomb.finish();
  ASSERT_LT(bytes.size(), 20'000U);
  const std::string refusal = test::refusal_of<InputError>(
      [&] { return read_mcap_bytes(bytes, "a.mcap", std::uint64_t{1} << 20); });
  EXPECT_NE(refusal.find("more than 1048576"), std::string::npos) << refusal;
}

TEST(McapReader, RefusesWhatIsNoMcap) {
  EXPECT_EQ(refusal_of(""), "a.mcap: file is empty");
  EXPECT_EQ(refusal_of("\x89MC"), "a.mcap: file ends inside the first 8 bytes, found 3 bytes");
  EXPECT_EQ(refusal_of("\x89MCAP1\r\n"),
            "a.mcap: is MCAP of another version (byte 5), found 1, expected 0");
  EXPECT_EQ(refusal_of("t,q,tau\n0,1,2\n"),
            "a.mcap: is not an MCAP file (byte 0), found 't,q,tau\\x0a', expected "
            "'\\x89MCAP0\\r\\n'");
}

}  // namespace
}  // namespace tribolog
