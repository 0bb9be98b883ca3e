// MCAP logs written by the format's own library (npm package @mcap/core). Its packages are fetched
// into the build directory once; where that cannot be, the tests skip.

#include <cmath>
#include <stdexcept>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include "ingest/bags/bag_readers.h"
#include "support/run_program.h"
#include "wording/words.h"

namespace tribolog::mcap_peer_test {
namespace {

const std::string packages = TRIBOLOG_PEER_PACKAGES;
const std::string peer = TRIBOLOG_SOURCE_DIR "/tests/ingest/bags/peer";

/// @return why there is no peer; empty: there is.
std::string missing_peer() {
  const test::ProgramRun run =
      test::run_shell("'" TRIBOLOG_SOURCE_DIR "/tests/support/npm_packages.sh' '" + packages +
                      "' '" + peer + "/package.json'");
  return run.status == 0 ? "" : run.out + run.err;
}

const ingest::log::LogColumn& column(const ingest::log::LogTable& table, std::string_view name) {
  for (const ingest::log::LogColumn& candidate : table.columns) {
    if (candidate.header.name == name) return candidate;
  }
  throw std::runtime_error("no column " + std::string(name));
}

class McapPeer : public testing::TestWithParam<const char*> {};

TEST_P(McapPeer, WritesLogsThatAreReadInFull) {
  if (const std::string missing = missing_peer(); !missing.empty()) {
    GTEST_SKIP() << "no peer: " << missing;
  }
  const test::ScratchDirectory scratch;
  const std::string path = scratch.file("peer.mcap");
  const test::ProgramRun run = test::run_shell("PEER_PACKAGES='" + packages + "' node '" + peer +
                                               "/write_mcap.mjs' '" + path + "' " + GetParam());
  ASSERT_EQ(run.status, 0) << run.err;

  const std::vector<ingest::log::LogTable> tables = ingest::bags::read_mcap(path);
  ASSERT_EQ(tables.size(), 1U);
  const ingest::log::LogTable& table = tables[0];
  EXPECT_EQ(table.group, "/joints");
  EXPECT_EQ(wording::words(table.notes),
            std::vector<std::string>{"/json is not read: no message holds a number"});
  EXPECT_EQ(table.columns.size(), 8U);  // two times, position and velocity of three joints
  ASSERT_EQ(table.rows, 200U);
  for (std::size_t i = 0; i < table.rows; ++i) {
    const auto number = static_cast<double>(i);
    EXPECT_EQ(column(table, "time").values[i], number * 1e6 / 1e9);
    EXPECT_EQ(column(table, "log_time").values[i], number * 1e6 / 1e9);
    EXPECT_EQ(column(table, "shoulder.position").values[i], number / 8);
    EXPECT_EQ(column(table, "elbow.position").values[i], number / 8 + 1);
    EXPECT_EQ(column(table, "wrist.position").values[i], number / 8 + 2);
    EXPECT_EQ(column(table, "wrist.velocity").values[i], -number);
  }
}

INSTANTIATE_TEST_SUITE_P(Forms, McapPeer,
                         testing::Values("none flat plain", "none chunked indexed",
                                         "none chunked plain", "lz4 chunked indexed",
                                         "lz4 chunked plain", "zstd chunked indexed",
                                         "zstd chunked plain"));

}  // namespace
}  // namespace tribolog::mcap_peer_test
