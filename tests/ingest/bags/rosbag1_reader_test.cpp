// Bags of ROS 1: what is cut off, not closed, damaged, encrypted or of another version.

#include <cstdint>
#include <string>
#include <vector>

#include <bzlib.h>
#include <gtest/gtest.h>
#include <lz4frame.h>

#include "base/error.h"
#include "base/temporary_directory.h"
#include "ingest/bags/as_in_csv.h"
#include "ingest/bags/bag_readers.h"
#include "support/bag_writer.h"
#include "support/damaged_files.h"
#include "wording/words.h"

namespace tribolog::rosbag1_reader_test {
namespace {

using namespace std::string_literals;
using Names = std::vector<std::string>;
using Values = std::vector<double>;

constexpr std::int64_t start_ns = 1'700'000'000'123'456'789;

std::string connection() {
  return test::bag_connection(0, "/joint_states", "sensor_msgs/JointState",
                              std::string(test::ros1_joint_state));
}

std::string message(int number) {
  const std::int64_t stamp_ns = start_ns + number * std::int64_t{1'000'001};
  test::Ros1Message bytes;
  bytes.add_header(stamp_ns).add_texts({"a", "b"});
  bytes.add_sequence({static_cast<double>(number), 10}).add_sequence({}).add_sequence({1, 2});
  return test::bag_message(0, static_cast<std::uint64_t>(stamp_ns) + 5, bytes.bytes());
}

std::string messages(int first, int end) {
  std::string records;
  for (int i = first; i < end; ++i) records += message(i);
  return records;
}

std::string bz2(const std::string& bytes) {
  std::string packed(bytes.size() + 1000, '\0');
  auto size = static_cast<unsigned>(packed.size());
  std::string copy = bytes;
  if (BZ2_bzBuffToBuffCompress(packed.data(), &size, copy.data(),
                               static_cast<unsigned>(copy.size()), 9, 0, 0) != BZ_OK) {
    throw std::runtime_error("bz2");
  }
  packed.resize(size);
  return packed;
}

std::string lz4(const std::string& bytes) {
  std::string packed(LZ4F_compressFrameBound(bytes.size(), nullptr), '\0');
  const std::size_t size =
      LZ4F_compressFrame(packed.data(), packed.size(), bytes.data(), bytes.size(), nullptr);
  if (LZ4F_isError(size) != 0) throw std::runtime_error("lz4");
  packed.resize(size);
  return packed;
}

std::string chunk(const std::string& records) {
  return test::bag_chunk("none", records, records.size());
}

std::string packed_chunk(const std::string& records) {
  return test::bag_chunk("bz2", bz2(records), records.size());
}

ingest::log::LogTable read(const std::string& bytes) {
  return ingest::bags::read_rosbag_bytes(bytes, "a.bag").at(0);
}

std::string refusal_of(const std::string& bytes) {
  return test::refusal_of<InputError>([&] { return read(bytes); });
}

const Values& values(const ingest::log::LogTable& table, std::string_view name) {
  for (const ingest::log::LogColumn& column : table.columns) {
    if (column.header.name == name) return column.values;
  }
  throw std::runtime_error("no column " + std::string(name));
}

TEST(Rosbag1Reader, GivesJointsByNameAndTheTimeOfTheirHeader) {
  const ingest::log::LogTable table = read(
      test::bag_start(1) + chunk(connection() + messages(0, 2)) + packed_chunk(messages(2, 4)));
  EXPECT_EQ(table.group, "/joint_states");
  EXPECT_EQ(table.header, (Names{"time [s]", "log_time [s]", "a.position", "b.position", "a.effort",
                                 "b.effort"}));
  EXPECT_EQ(values(table, "a.position"), (Values{0, 1, 2, 3}));
  EXPECT_EQ(values(table, "time"), (Values{0, 0.001000001, 0.002000002, 0.003000003}));
  EXPECT_EQ(wording::words(table.notes), Names{});
}

TEST(Rosbag1Reader, ReadsWhatARecorderHasNotClosed) {
  const Names not_closed = {"has no index: the recording was not closed"};
  const ingest::log::LogTable whole =
      read(test::bag_start(0) + chunk(connection() + messages(0, 3)));
  EXPECT_EQ(whole.rows, 3U);
  EXPECT_EQ(wording::words(whole.notes), not_closed);
  // The chunk that is being written states no sizes yet.
  const ingest::log::LogTable open =
      read(test::bag_start(0) + chunk(connection() + messages(0, 3)) +
           test::bag_chunk("none", "", 0) + messages(3, 5) + message(5).substr(0, 90));
  EXPECT_EQ(values(open, "a.position"), (Values{0, 1, 2, 3, 4}));
  const std::string records = connection() + messages(0, 20'000);  // of several blocks
  const std::string packed = bz2(records);
  const std::string start = test::bag_start(0) + test::bag_chunk("bz2", "", 0);
  EXPECT_EQ(read(start + packed).rows, 20'000U);
  const ingest::log::LogTable cut = read(start + packed.substr(0, packed.size() / 2));
  EXPECT_GT(cut.rows, 3'000U);
  EXPECT_LT(cut.rows, 12'000U);
  EXPECT_EQ(wording::words(cut.notes), not_closed);
}

TEST(Rosbag1Reader, SaysWhereTheFileIsCut) {
  const std::string start = test::bag_start(1);
  const std::string first = chunk(connection() + messages(0, 2));
  const std::string second = packed_chunk(messages(2, 4));
  const std::string whole = start + first + second;
  const ingest::log::LogTable table = read(whole.substr(0, whole.size() - 70));
  EXPECT_EQ(table.rows, 2U);
  const std::size_t stored = bz2(messages(2, 4)).size();
  EXPECT_EQ(wording::words(table.notes),
            Names{"truncated in chunk at byte " + std::to_string(start.size() + first.size()) +
                  ": expected " + std::to_string(stored) + " bytes, ended after " +
                  std::to_string(stored - 70)});
}

TEST(Rosbag1Reader, LeavesOutDamagedChunksAndGoesOn) {
  std::string damaged = packed_chunk(messages(2, 4));
  damaged[damaged.size() - 20] = static_cast<char>(damaged[damaged.size() - 20] ^ 1);
  const std::string start = test::bag_start(1) + chunk(connection() + messages(0, 2));
  const ingest::log::LogTable table = read(start + damaged + chunk(messages(4, 6)));
  EXPECT_EQ(values(table, "a.position"), (Values{0, 1, 4, 5}));
  EXPECT_EQ(wording::words(table.notes),
            Names{"chunk at byte " + std::to_string(start.size()) + " is left out: bz2: error -4"});
  const std::string records = messages(2, 4);
  EXPECT_EQ(wording::words(read(start + test::bag_chunk("none", records, 7)).notes),
            Names{"chunk at byte " + std::to_string(start.size()) +
                  " is left out: gives more than the 7 bytes stated"});
  EXPECT_EQ(wording::words(read(start + test::bag_chunk("xz", records, 7)).notes),
            Names{"chunk at byte " + std::to_string(start.size()) +
                  " is left out: is compressed with 'xz'"});
}

TEST(Rosbag1Reader, RefusesWhatItCannotRead) {
  const std::string records = connection() + messages(0, 2);
  EXPECT_EQ(refusal_of(test::bag_start(1, "rosbag/AesCbcEncryptor") + chunk(records)),
            "a.bag: is an encrypted bag, found 'rosbag/AesCbcEncryptor', expected a bag without "
            "encryption; hint: rosbag decrypt a.bag where its key is");
  EXPECT_EQ(refusal_of("#ROSBAG V1.2\n" + records),
            R"(a.bag: is a bag of another version (byte 9), found '#ROSBAG V1.2\x0a', expected )"
            "'#ROSBAG V2.0'; hint: rosbag filter a.bag new.bag True");
  EXPECT_EQ(refusal_of(""), "a.bag: file is empty");
  EXPECT_EQ(refusal_of("#ROSBAG"), "a.bag: file ends inside the first 13 bytes, found '#ROSBAG'");
  EXPECT_EQ(
      refusal_of("PK\3\4 and so on"),
      R"(a.bag: is not a bag (byte 0), found 'PK\x03\x04 and so o', expected '#ROSBAG V2.0')");
  EXPECT_EQ(
      refusal_of(test::bag_start(1) + chunk(test::bag_connection(0, "/t", "a/B", "C c\n"))),
      "a.bag: holds no topic with numbers that can be read, expected messages of ROS, JSON or "
      "protobuf, such as sensor_msgs/JointState");
  EXPECT_EQ(refusal_of(test::bag_start(1) +
                       chunk(test::bag_connection(0, "/t", "a/B", "C c\n") + messages(0, 1))),
            "a.bag: holds no topic with numbers that can be read, found /t is not read: type 'a/C' "
            "is not defined, expected messages of ROS, JSON or protobuf, such as "
            "sensor_msgs/JointState");
}

TEST(Rosbag1Reader, SaysWhichMessageDisagreesWithItsType) {
  test::Ros1Message bad;
  bad.add_header(0).add_texts({"a"}).add_sequence({1, 2}).add_sequence({}).add_sequence({});
  const std::string start = test::bag_start(1);
  const std::string before = connection() + messages(0, 1);
  EXPECT_EQ(
      refusal_of(start + chunk(before + test::bag_message(0, 0, bad.bytes()))),
      "a.bag: message 2 of /joint_states has 2 elements in position, where 1 have a name (byte " +
          std::to_string(before.size()) + " of the chunk at byte " + std::to_string(start.size()) +
          ")");
}

TEST(Rosbag1Reader, AnElementOfNoBytesIsNoLoop) {
  const std::string definition =
      "a/None[4000000000] many\na/None[] some\nfloat64 x\n===\nMSG: a/None\na/Less[4000000000] "
      "less\n"
      "===\nMSG: a/Less\nuint8[0] no\n";
  test::Ros1Message bytes;
  bytes.add(std::uint32_t{3}).add(2.5);
  const ingest::log::LogTable table =
      read(test::bag_start(1) + chunk(test::bag_connection(0, "/t", "a/B", definition) +
                                      test::bag_message(0, 0, bytes.bytes())));
  EXPECT_EQ(values(table, "x"), Values{2.5});
}

TEST(Rosbag1Reader, BoundsWhatItKeepsInMemory) {
  const std::string records = connection() + messages(0, 500);
  const auto read_bounded = [](const std::string& bytes) {
    return ingest::bags::read_rosbag_bytes(bytes, "a.bag", 1000).at(0);
  };
  const std::string start = test::bag_start(1) + chunk(connection() + messages(0, 1));
  EXPECT_EQ(wording::words(read_bounded(start + packed_chunk(records)).notes),
            Names{"chunk at byte " + std::to_string(start.size()) + " is left out: it states " +
                  std::to_string(records.size()) + " bytes unpacked, more than 1000"});
  EXPECT_EQ(test::refusal_of<InputError>([&] {
              return read_bounded(start + test::bag_message(0, 0, std::string(1001, 'x')));
            }),
            "a.bag: message at byte " + std::to_string(start.size()) +
                " is too large, found 1001 bytes, expected at most 1000");
}

TEST(Rosbag1Reader, AnswersWhateverIsDamaged) {
  const std::string first = connection() + messages(0, 6);
  const std::string second = messages(6, 12);
  struct Packed {
    const char* compression;
    std::string (*pack)(const std::string& bytes);
  };
  const auto as_it_is = [](const std::string& bytes) { return bytes; };
  for (const auto& [compression, pack] :
       {Packed{"none", as_it_is}, Packed{"bz2", bz2}, Packed{"lz4", lz4}}) {
    SCOPED_TRACE(compression);
    const std::string bag = test::bag_start(1) +
                            test::bag_chunk(compression, pack(first), first.size()) +
                            test::bag_chunk(compression, pack(second), second.size());
    ASSERT_EQ(read(bag).rows, 12U);
    test::expect_mutants_answered(read, bag, 500);
  }
}

}  // namespace
}  // namespace tribolog::rosbag1_reader_test
