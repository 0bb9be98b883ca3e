// Messages in JSON, protobuf and of ROS 1 in MCAP, and bags of ROS 1, written by the libraries of
// these formats (npm: @mcap/core, protobufjs; PyPI: rosbags), to the same numbers as the CSV of the
// same data. The packages are fetched into the build directory once; where that cannot be, the
// tests skip.

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "ingest/bags/as_in_csv.h"
#include "ingest/bags/bag_readers.h"
#include "ingest/log/log_format.h"
#include "support/run_program.h"
#include "wording/words.h"

namespace tribolog::messages_peer_test {
namespace {

const std::string npm_packages = TRIBOLOG_PEER_PACKAGES;
const std::string python_packages = TRIBOLOG_PEER_PACKAGES "_python";
const std::string peer = TRIBOLOG_SOURCE_DIR "/tests/ingest/bags/peer";

std::string quoted(const std::string& text) { return "'" + text + "'"; }

/// @return why there are none; empty: there are.
std::string missing(const char* script, const std::string& packages, const char* wanted) {
  const test::ProgramRun run =
      test::run_shell(quoted(std::string(TRIBOLOG_SOURCE_DIR "/tests/support/") + script) + " " +
                      quoted(packages) + " " + quoted(peer + "/" + wanted));
  return run.status == 0 ? "" : run.out + run.err;
}

TEST(MessagesPeer, WritesMcapWithMessagesOfEveryEncoding) {
  const std::string why = missing("npm_packages.sh", npm_packages, "package.json");
  if (!why.empty()) GTEST_SKIP() << "no peer: " << why;
  const test::ScratchDirectory scratch;
  const std::string path = scratch.file("peer.mcap");
  const test::ProgramRun run = test::run_shell("PEER_PACKAGES=" + quoted(npm_packages) + " node " +
                                               quoted(peer + "/write_messages.mjs") + " " +
                                               quoted(path) + " " + quoted(scratch.file("")));
  ASSERT_EQ(run.status, 0) << run.err;

  const std::vector<ingest::log::LogTable> tables = ingest::bags::read_mcap(path);
  EXPECT_EQ(tables.size(), 6U);
  for (const char* const topic :
       {"json_states", "json_iso", "json_flat", "pb_states", "pb_state", "ros1_states"}) {
    test::expect_as_in_csv(test::table_of(tables, std::string("/") + topic),
                           scratch.file(std::string(topic) + ".csv"));
  }
  const std::vector<std::string> left_out = {
      "/json_flat: cloud has more than 64 elements and was not read"};
  EXPECT_EQ(wording::words(test::table_of(tables, "/json_flat").notes), left_out);
}

class BagPeer : public testing::TestWithParam<const char*> {
 protected:
  /// And its topics as CSV beside it.
  static void write_bag(const test::ScratchDirectory& scratch, const std::string& path) {
    const test::ProgramRun run = test::run_shell(
        quoted(python_packages + "/bin/python") + " " + quoted(peer + "/write_bag.py") + " " +
        quoted(path) + " " + GetParam() + " " + quoted(scratch.file("")));
    ASSERT_EQ(run.status, 0) << run.err;
  }
};

TEST_P(BagPeer, WritesBagsThatAreReadInFull) {
  const std::string why = missing("python_packages.sh", python_packages, "requirements.txt");
  if (!why.empty()) GTEST_SKIP() << "no peer: " << why;
  const test::ScratchDirectory scratch;
  const std::string path = scratch.file("peer.bag");
  ASSERT_NO_FATAL_FAILURE(write_bag(scratch, path));

  EXPECT_EQ(ingest::log::detect_log_format(read_file(path).substr(0, 64), path),
            ingest::log::LogFormat::rosbag);
  const std::vector<ingest::log::LogTable> tables = ingest::bags::read_rosbag(path);
  ASSERT_EQ(tables.size(), 2U);
  for (const char* const topic : {"joint_states", "state"}) {
    const ingest::log::LogTable& table = test::table_of(tables, std::string("/") + topic);
    test::expect_as_in_csv(table, scratch.file(std::string(topic) + ".csv"));
  }
}

TEST_P(BagPeer, GivesOfACutBagWhatStandsBeforeTheCut) {
  const std::string why = missing("python_packages.sh", python_packages, "requirements.txt");
  if (!why.empty()) GTEST_SKIP() << "no peer: " << why;
  const test::ScratchDirectory scratch;
  const std::string path = scratch.file("peer.bag");
  ASSERT_NO_FATAL_FAILURE(write_bag(scratch, path));
  const std::string bytes = read_file(path);
  const std::vector<ingest::log::LogTable> whole = ingest::bags::read_rosbag(path);
  std::size_t rows_before = 0;
  for (std::size_t cut = bytes.size() / 8; cut < bytes.size(); cut += bytes.size() / 37) {
    std::size_t rows = 0;
    try {
      const auto tables = ingest::bags::read_rosbag_bytes({bytes.data(), cut}, "cut.bag");
      rows = tables.front().rows;
      for (const ingest::log::LogColumn& column : tables.front().columns) {
        const auto full =
            std::find_if(whole.front().columns.begin(), whole.front().columns.end(),
                         [&](const auto& one) { return one.header.name == column.header.name; });
        ASSERT_NE(full, whole.front().columns.end());
        EXPECT_TRUE(std::equal(column.values.begin(), column.values.end(), full->values.begin()));
      }
    } catch (const InputError&) {
      EXPECT_EQ(rows_before, 0U) << "cut at " << cut;
    }
    EXPECT_GE(rows, rows_before);
    rows_before = rows;
  }
  EXPECT_EQ(rows_before, 200U);
}

INSTANTIATE_TEST_SUITE_P(Compressions, BagPeer, testing::Values("none", "bz2", "lz4"));

}  // namespace
}  // namespace tribolog::messages_peer_test
