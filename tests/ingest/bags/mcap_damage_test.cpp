// MCAP logs that are cut off, damaged or something else.

#include <random>

#include <gtest/gtest.h>

#include "ingest/bags/numbered_log.h"
#include "support/bag_writer.h"
#include "support/breadth.h"
#include "support/damaged_files.h"
#include "wording/words.h"

namespace tribolog::mcap_damage_test {
namespace {

using namespace test;
using Names = std::vector<std::string>;

TEST(McapDamage, ReadsAllMessagesBeforeTheCutAndInventsNone) {
  std::mt19937 random(5);
  std::size_t cut_positions = 0;
  for (const test::McapOptions& form : test::all_forms()) {
    test::McapWriter log = test::numbered_log(form);
    const std::string bytes = log.finish();
    for (std::size_t trial = 0; trial < test::seeds_of(75, 300); ++trial) {
      const std::size_t cut = random() % bytes.size();
      const auto complete = static_cast<std::size_t>(
          std::count_if(log.readable_from().begin(), log.readable_from().end(),
                        [&](std::size_t end) { return end <= cut; }));
      SCOPED_TRACE(test::shown(form) + ", cut at byte " + std::to_string(cut));
      ++cut_positions;
      std::vector<ingest::log::LogTable> tables;
      try {
        tables = test::read(bytes.substr(0, cut));
      } catch (const InputError& error) {
        ASSERT_EQ(complete, 0U) << error.what();
        continue;
      }
      ASSERT_EQ(tables.size(), 1U);
      // A compressed chunk may give some of its messages though its end is missing.
      ASSERT_GE(tables[0].rows, complete);
      ASSERT_LT(tables[0].rows, complete + (form.compression.empty() ? 1 : 8));
      test::expect_numbered(tables[0], tables[0].rows);
      ASSERT_EQ(tables[0].notes.size(), 1U);
    }
  }
  EXPECT_EQ(cut_positions, 14 * test::seeds_of(75, 300));
}

TEST(McapDamage, SaysWhereTheFileIsCut) {
  test::McapWriter log = test::numbered_log({});
  const std::string bytes = log.finish();
  const std::size_t end = log.readable_from().at(9);
  const std::string byte = std::to_string(end);
  const std::string length = std::to_string(log.readable_from().at(10) - end - 9);
  const auto notes = [&](std::size_t bytes_kept) {
    return wording::words(test::read(bytes.substr(0, bytes_kept)).at(0).notes);
  };
  EXPECT_EQ(notes(end),
            Names{"ends at byte " + byte + " without a footer: the recording was not closed"});
  EXPECT_EQ(notes(end + 4), Names{"truncated in the start of a record at byte " + byte +
                                  ": expected 9 bytes, ended after 4"});
  EXPECT_EQ(notes(end + 19), Names{"truncated in message (0x05) at byte " + byte + ": expected " +
                                   length + " bytes, ended after 10"});
  EXPECT_EQ(notes(bytes.size() - 3).at(0).substr(0, 16), "damaged at byte ");
  EXPECT_EQ(wording::words(test::read(bytes + "more").at(0).notes),
            Names{"4 bytes after the log's end at byte " + std::to_string(bytes.size()) +
                  " are not read"});
}

TEST(McapDamage, ChangedBytesNeverCrashIt) {
  std::mt19937 random(11);
  std::size_t read_all = 0;
  std::size_t trials = 0;
  for (const test::McapOptions& form : test::all_forms()) {
    const std::string bytes = test::numbered_log(form).finish();
    for (std::size_t trial = 0; trial < test::seeds_of(125, 500); ++trial, ++trials) {
      std::string changed = bytes;
      changed[random() % bytes.size()] ^= static_cast<char>(1 + random() % 255);
      try {
        const std::vector<ingest::log::LogTable> tables = test::read(changed);
        read_all += tables.size() == 1 && tables[0].rows == test::message_count ? 1 : 0;
      } catch (const InputError& error) {
        ASSERT_EQ(std::string(error.what()).find('\n'), std::string::npos);
      }
    }
  }
  EXPECT_GT(read_all, 0U);
  EXPECT_LT(read_all, trials);
}

TEST(McapDamage, AnswersWhateverIsDamagedAroundMessagesOfRos1) {
  test::McapWriter writer({0, "", false, false});
  writer.add_schema(1, "sensor_msgs/JointState", "ros1msg", test::ros1_joint_state);
  writer.add_channel(1, 1, "/joint_states", "ros1");
  for (int i = 0; i < 4; ++i) {
    test::Ros1Message message;
    message.add_header(1'700'000'000'000'000'000 + i).add_texts({"a", "b"});
    message.add_sequence({1.0 * i, 10}).add_sequence({}).add_sequence({1, 2});
    writer.add_message(1, static_cast<std::uint64_t>(i), message.bytes());
  }
  const std::string bytes = writer.finish();
  ASSERT_EQ(test::read(bytes).at(0).rows, 4U);
  test::expect_mutants_answered(test::read, bytes, 500);
}

TEST(McapDamage, ReadsOnAfterWhatLooksLikeTheEndOfTheData) {
  for (const std::size_t messages_per_chunk : {0, 1}) {
    test::McapWriter writer = test::writer_with_joints({messages_per_chunk, "", true, true});
    writer.add_message(3, 0, test::numbered_message(0).cdr());
    writer.add_record(0x0f, std::string(4, '\0'));
    writer.add_message(3, 1, test::numbered_message(1).cdr());
    EXPECT_EQ(test::read(writer.finish()).at(0).rows, 2U);
  }
}

TEST(McapDamage, LeavesOutAChunkWhoseCrcDisagrees) {
  test::McapWriter log = test::numbered_log({10, "", true, true});
  std::string bytes = log.finish();
  bytes[log.readable_from().at(25) - 1] ^= 1;  // in the effort of a message of the third chunk
  const ingest::log::LogTable table = test::read(bytes).at(0);
  EXPECT_EQ(table.rows, test::message_count - 10);
  EXPECT_EQ(test::column(table, "a.position").values.at(20), 30);
  ASSERT_EQ(table.notes.size(), 1U);
  EXPECT_NE(wording::words(table.notes[0]).find("is left out: its CRC is "), std::string::npos)
      << wording::words(table.notes[0]);
}

TEST(McapDamage, TrustsNoLength) {
  const std::string head = test::numbered_log({}).finish().substr(0, 8);
  const std::string endless(8, '\x7f');
  for (char opcode = 1; opcode < 16; ++opcode) {
    const std::string refusal = test::refusal_of(head + opcode + endless);
    EXPECT_NE(refusal.find("holds no topic with numbers"), std::string::npos) << refusal;
  }
  // 64 MiB of zeros in 6 kB of zstd, where 1 MiB is allowed.
  const std::string zeros(std::size_t{64} << 20, '\0');
  test::McapWriter bomb = test::writer_with_joints({1, "zstd", false, false});
  bomb.add_message(3, 0, zeros);
  const std::string bytes = bomb.finish();
  ASSERT_LT(bytes.size(), 20'000U);
  const std::string refusal = test::refusal_of<InputError>(
      [&] { return ingest::bags::read_mcap_bytes(bytes, "a.mcap", std::uint64_t{1} << 20); });
  EXPECT_NE(refusal.find("more than 1048576"), std::string::npos) << refusal;
}

TEST(McapDamage, RefusesWhatIsNoMcap) {
  EXPECT_EQ(test::refusal_of(""), "a.mcap: file is empty");
  EXPECT_EQ(test::refusal_of("\x89MC"),
            "a.mcap: file ends inside the first 8 bytes, found 3 bytes");
  EXPECT_EQ(test::refusal_of("\x89MCAP1\r\n"),
            "a.mcap: is MCAP of another version (byte 5), found 1, expected 0");
  EXPECT_EQ(test::refusal_of("t,q,tau\n0,1,2\n"),
            "a.mcap: is not an MCAP file (byte 0), found 't,q,tau\\x0a', expected "
            "'\\x89MCAP0\\r\\n'");
}

}  // namespace
}  // namespace tribolog::mcap_damage_test
