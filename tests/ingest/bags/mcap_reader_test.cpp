// MCAP logs: what is read, and what is left out.

#include <cmath>

#include <gtest/gtest.h>

#include "ingest/bags/bag_readers.h"
#include "ingest/bags/numbered_log.h"
#include "wording/words.h"

namespace tribolog::mcap_reader_test {
namespace {

using namespace test;
using Values = std::vector<double>;
using Names = std::vector<std::string>;

TEST(McapReader, ReadsChunkedAndFlatWithEveryCompressionIndexedOrNot) {
  for (const test::McapOptions& form : test::all_forms()) {
    SCOPED_TRACE(test::shown(form));
    const std::vector<ingest::log::LogTable> tables = test::read(test::numbered_log(form).finish());
    ASSERT_EQ(tables.size(), 1U);
    EXPECT_EQ(tables[0].group, "/joint_states");
    EXPECT_EQ(wording::words(tables[0].notes), Names{});
    test::expect_numbered(tables[0], test::message_count);
  }
}

TEST(McapReader, ReadsTheSameFromAFile) {
  const test::TemporaryDirectory directory;
  const std::string path =
      directory.file("a log.mcap", test::numbered_log({7, "zstd", true, true}).finish());
  const std::vector<ingest::log::LogTable> tables = ingest::bags::read_mcap(path);
  EXPECT_EQ(tables.at(0).file, path);
  test::expect_numbered(tables.at(0), test::message_count);
  EXPECT_EQ(test::refusal_of<InputError>([&] { return ingest::bags::read_mcap(directory.path()); }),
            directory.path() + ": cannot read: is a directory");
}

TEST(McapReader, MatchesJointsByNameAndCountsGaps) {
  const ingest::log::LogTable table =
      test::read(test::log_of({{0, {"a", "b"}, {1, 2}, {}, {5, 6}},
                               {1, {"b", "c"}, {3, 4}, {}, {}},
                               {2, {}, {}, {}, {}},
                               {3, {"c", "b", "a"}, {7, 8, 9}, {}, {1, 2, 3}}}))
          .at(0);
  EXPECT_EQ(table.header, (Names{"time [s]", "log_time [s]", "a.position", "b.position", "a.effort",
                                 "b.effort", "c.position", "c.effort"}));
  const ingest::log::LogColumn& a = test::column(table, "a.position");
  EXPECT_EQ(a.gaps, 2U);
  EXPECT_EQ(a.values.at(0), 1);
  EXPECT_TRUE(std::isnan(a.values.at(1)));
  EXPECT_TRUE(std::isnan(a.values.at(2)));
  EXPECT_EQ(a.values.at(3), 9);
  EXPECT_EQ(test::column(table, "b.effort").gaps, 2U);
  EXPECT_EQ(test::column(table, "b.effort").values.at(3), 2);
  EXPECT_EQ(test::column(table, "c.position").values.at(3), 7);
}

TEST(McapReader, KeepsOddNames) {
  const std::string spaced = "arm 1/joint.2 [x]";
  const std::string odd = std::string("\xc3\xa9\n\x01") + '\0' + "z";
  const ingest::log::LogTable table =
      test::read(test::log_of({{0, {spaced, "", odd}, {1, 2, 3}, {}, {}}})).at(0);
  EXPECT_EQ(test::column(table, spaced + ".position").values, Values{1});
  EXPECT_EQ(test::column(table, odd + ".position").values, Values{3});
}

TEST(McapReader, RefusesArraysOfAnotherLengthWithMessageAndByte) {
  test::McapWriter writer = test::writer_with_joints({});
  writer.add_message(3, 0, test::JointStateMessage{0, {"a"}, {1}, {}, {}}.cdr());
  const std::size_t byte = writer.readable_from().at(0);
  writer.add_message(3, 0, test::JointStateMessage{0, {"a", "b"}, {1, 2}, {1, 2, 3}, {}}.cdr());
  EXPECT_EQ(
      test::refusal_of(writer.finish()),
      "a.mcap: message 2 of /joint_states has 3 elements in velocity, where 2 have a name (byte " +
          std::to_string(byte) + ")");
  EXPECT_NE(
      test::refusal_of(test::log_of({{0, {"a", "a"}, {1, 2}, {}, {}}})).find("names 'a' twice"),
      std::string::npos);
}

TEST(McapReader, ADamagedMessageConcernsItsTopicAlone) {
  test::McapWriter writer = test::writer_with_joints({4, "zstd", true, true});
  writer.add_channel(4, 7, "/broken");
  for (std::size_t i = 0; i < 9; ++i) {
    writer.add_message(3, i, test::numbered_message(i).cdr());
    writer.add_message(4, i, i < 2 ? test::numbered_message(i).cdr() : "cut");
  }
  const std::vector<ingest::log::LogTable> tables = test::read(writer.finish());
  ASSERT_EQ(tables.size(), 2U);
  EXPECT_EQ(tables[0].refusal, "");
  EXPECT_EQ(test::column(tables[0], "a.position").values, (Values{0, 1, 2, 3, 4, 5, 6, 7, 8}));
  EXPECT_NE(tables[1].refusal.find("message 3 of /broken "), std::string::npos);
  EXPECT_EQ(tables[1].rows, 2U);
  EXPECT_EQ(test::column(tables[1], "a.position").values, (Values{0, 1}));
}

TEST(McapReader, KeepsNanosecondsOfLargeTimes) {
  const std::int64_t late_ns = 2'147'483'647'000'000'000;
  const ingest::log::LogTable table =
      test::read(test::log_of({{late_ns, {"a"}, {1}, {}, {}}, {late_ns + 1, {"a"}, {1}, {}, {}}}))
          .at(0);
  EXPECT_EQ(test::column(table, "time").values, (Values{0, 1e-9}));
}

TEST(McapReader, NamesTopicsThatItDoesNotRead) {
  test::McapWriter writer = test::writer_with_joints({});
  writer.add_schema(8, "pkg/msg/Idl", "ros2idl", "struct Idl {};");
  writer.add_schema(9, "pkg/msg/Broken", "ros2msg", "Missing field\n");
  writer.add_channel(10, 0, "/flat", "flatbuffer");
  writer.add_channel(11, 8, "/idl");
  writer.add_channel(12, 9, "/broken");
  writer.add_channel(13, 0, "/bare");
  writer.add_channel(14, 9, "/silent");
  for (const std::uint16_t channel : {10, 11, 12, 13, 99}) writer.add_message(channel, 0, "{}");
  writer.add_message(3, 0, test::numbered_message(0).cdr());
  const std::vector<ingest::log::LogTable> tables = test::read(writer.finish());
  ASSERT_EQ(tables.size(), 1U);
  EXPECT_EQ(
      wording::words(tables[0].notes),
      (Names{"/flat is not read: messages are encoded as 'flatbuffer', not as cdr, ros1, json or "
             "protobuf",
             "/idl is not read: pkg/msg/Idl is defined in 'ros2idl', not in ros2msg",
             "/broken is not read: type 'pkg/Missing' is not defined",
             "/bare is not read: the log does not say what its messages consist of",
             "messages left out because no channel record precedes them: 1"}));
}

TEST(McapReader, JoinsChannelsOfOneTopicAndSeparatesTopics) {
  test::McapWriter writer = test::writer_with_joints({4, "lz4", true, true});
  writer.add_channel(4, 7, "/joint_states");
  writer.add_channel(5, 7, "/other");
  for (std::size_t i = 0; i < 9; ++i) {
    writer.add_message(static_cast<std::uint16_t>(3 + i % 3), i, test::numbered_message(i).cdr());
  }
  const std::vector<ingest::log::LogTable> tables = test::read(writer.finish());
  ASSERT_EQ(tables.size(), 2U);
  EXPECT_EQ(tables[0].rows, 6U);
  EXPECT_EQ(test::column(tables[0], "a.position").values, (Values{0, 1, 3, 4, 6, 7}));
  EXPECT_EQ(test::column(tables[1], "a.position").values, (Values{2, 5, 8}));
}

TEST(McapReader, SkipsAttachmentsAndUnknownRecords) {
  test::McapWriter writer = test::writer_with_joints({3, "zstd", true, true});
  writer.add_message(3, 0, test::numbered_message(0).cdr());
  writer.add_record(0x09, std::string(300'000, 'x'));
  writer.add_record(0x83, "of another program");
  writer.add_message(3, 1, test::numbered_message(1).cdr());
  EXPECT_EQ(test::column(test::read(writer.finish()).at(0), "a.position").values, (Values{0, 1}));
}

TEST(McapReader, KeepsAFieldOfTheNameOfAColumnOfItsOwn) {
  test::McapWriter writer({});
  writer.add_schema(1, "pkg/msg/State", "ros2msg", "std_msgs/Header header\nfloat64 time\n");
  writer.add_channel(1, 1, "/state");
  writer.add_message(1, 0, test::CdrWriter().add_header(8).add(4.5).message());
  const ingest::log::LogTable table = test::read(writer.finish()).at(0);
  EXPECT_EQ(table.header, (Names{"time [s]", "log_time [s]", "message.time"}));
  EXPECT_EQ(test::column(table, "message.time").values, Values{4.5});
}

}  // namespace
}  // namespace tribolog::mcap_reader_test
