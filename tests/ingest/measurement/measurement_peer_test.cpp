// Files of measurement systems, written by programs of others (asammdf and npTDMS from PyPI): they
// are read to the numbers that stand in the CSV beside them. The packages are fetched into the
// build directory once; where that cannot be, the tests skip.

#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/input_file.h"
#include "ingest/measurement/measured_bytes.h"
#include "ingest/measurement/measurement_readers.h"
#include "ingest/text/csv_reader.h"
#include "support/damaged_files.h"
#include "support/run_program.h"
#include "wording/words.h"

namespace tribolog::measurement_peer_test {
namespace {

using ingest::log::ColumnReading;
using ingest::log::LogColumn;
using ingest::log::LogTable;
using test::measured::column;

const std::string peer = TRIBOLOG_SOURCE_DIR "/tests/ingest/measurement/peer";

/// @return why there is no peer; empty: there is.
std::string missing_peer() {
  const test::ProgramRun run = test::run_shell(
      "'" TRIBOLOG_SOURCE_DIR "/tests/support/python_packages.sh' '" TRIBOLOG_PEER_PYTHON "' '" +
      peer + "/requirements.txt'");
  return run.status == 0 ? "" : run.out + run.err;
}

/// Runs one of the peer's scripts. @return false: it failed, and the test with it.
void write(const std::string& script, const std::string& arguments) {
  const test::ProgramRun run = test::run_shell("'" TRIBOLOG_PEER_PYTHON "/bin/python' '" + peer +
                                               "/" + script + "' " + arguments);
  ASSERT_EQ(run.status, 0) << run.err;
}

/// Words by themselves, not by their places.
std::string shown(const LogColumn& column, std::size_t row) {
  const double value = column.values.at(row);
  return std::isnan(value) ? "gap" : column.words.at(static_cast<std::size_t>(value));
}

/// All columns of the CSV stand in the table, with its numbers, gaps and words.
void expect_same(const LogTable& table, const std::string& csv,
                 const std::vector<std::string>& names, const std::string& words = "") {
  std::vector<ingest::log::WantedColumn> wanted;
  for (const std::string& name : names) wanted.push_back({name});
  if (!words.empty()) wanted.push_back({words, "", ColumnReading::words});
  const LogTable expected = ingest::text::read_csv(read_file(csv), csv, wanted);
  ASSERT_EQ(table.rows, expected.rows);
  for (const LogColumn& there : expected.columns) {
    const LogColumn& read = column(table, there.header.name);
    EXPECT_EQ(read.gaps, there.gaps) << there.header.name;
    EXPECT_EQ(read.reading == ColumnReading::words, there.header.name == words);
    for (std::size_t row = 0; row < table.rows; ++row) {
      SCOPED_TRACE(there.header.name + ", row " + std::to_string(row));
      if (there.header.name == words) {
        ASSERT_EQ(shown(read, row), shown(there, row));
      } else if (std::isnan(there.values[row])) {
        ASSERT_TRUE(std::isnan(read.values[row]));
      } else {
        ASSERT_DOUBLE_EQ(read.values[row], there.values[row]);
      }
    }
  }
}

class MdfPeer : public testing::TestWithParam<const char*> {};

TEST_P(MdfPeer, WritesFilesThatAreReadInFull) {
  if (const std::string missing = missing_peer(); !missing.empty()) {
    GTEST_SKIP() << "no peer: " << missing;
  }
  const test::ScratchDirectory scratch;
  const std::string path = scratch.file("peer.mf4");
  write("write_mf4.py", "'" + path + "' " + GetParam());

  const std::vector<LogTable> tables = ingest::measurement::read_mdf(path);
  ASSERT_EQ(tables.size(), 2U);
  EXPECT_EQ(tables[0].group, "joint");
  EXPECT_EQ(tables[1].group, "drive");
  expect_same(tables[0], path + ".joint.csv",
              {"time", "Position", "Torque", "Half", "Counter", "Wide", "Speed"});
  expect_same(tables[1], path + ".drive.csv",
              {"time", "Current", "Interpolated", "Nearest", "Ranges", "Rational"}, "State");
  EXPECT_EQ(column(tables[0], "time").header.unit, "s");
  EXPECT_EQ(column(tables[0], "Torque").header.unit, "Nm");
  EXPECT_EQ(column(tables[0], "Speed").gaps, 10U);
  EXPECT_EQ(column(tables[1], "Current").header.unit, "A");
  EXPECT_EQ(wording::words(tables[0].notes),
            (std::vector<std::string>{"'drive/Formula' is not read: its conversion is a formula",
                                      "'drive/Remark' is not read: it holds texts"}));
}

/// Compression (none, deflate, transposed), bytes in one block, version.
INSTANTIATE_TEST_SUITE_P(Forms, MdfPeer,
                         testing::Values("0 0 4.10", "1 0 4.10", "2 0 4.10", "0 4000 4.00",
                                         "1 4000 4.10", "2 4000 4.11", "2 3999 4.20"));

TEST(MdfPeer, MutantsOfItsFilesAreReadOrRefused) {
  if (const std::string missing = missing_peer(); !missing.empty()) {
    GTEST_SKIP() << "no peer: " << missing;
  }
  const test::ScratchDirectory scratch;
  for (const char* form : {"0 4000 4.10", "2 4000 4.10"}) {
    const std::string path = scratch.file("peer.mf4");
    write("write_mf4.py", "'" + path + "' " + form);
    const auto read = [](const std::string& bytes) {
      return ingest::measurement::parse_mdf(bytes, "run.mf4");
    };
    test::expect_mutants_answered(read, read_file(path), 500);
  }
}

class TdmsPeer : public testing::TestWithParam<int> {};

TEST_P(TdmsPeer, WritesFilesThatAreReadInFull) {
  if (const std::string missing = missing_peer(); !missing.empty()) {
    GTEST_SKIP() << "no peer: " << missing;
  }
  const test::ScratchDirectory scratch;
  const std::string path = scratch.file("peer.tdms");
  write("write_tdms.py", "'" + path + "' " + std::to_string(GetParam()));

  const std::vector<LogTable> tables = ingest::measurement::read_tdms(path);
  ASSERT_EQ(tables.size(), 2U);
  EXPECT_EQ(tables[0].group, "joint");
  EXPECT_EQ(tables[1].group, "drive");
  expect_same(tables[0], path + ".joint.csv", {"time", "Position", "Torque", "Current", "Curve"});
  expect_same(tables[1], path + ".drive.csv",
              {"Stamp", "as i1", "as i2", "as i4", "as i8", "as u1", "as u2", "as u4", "as u8",
               "as f4", "as f8", "enabled"});
  EXPECT_EQ(column(tables[0], "Torque").header.unit, "Nm");
  EXPECT_EQ(column(tables[1], "Stamp").header.unit, "s");
  EXPECT_EQ(wording::words(tables[0].notes),
            std::vector<std::string>{"'drive/remark' is not read: it holds texts"});
}

INSTANTIATE_TEST_SUITE_P(Segments, TdmsPeer, testing::Values(1, 3, 100));

TEST(TdmsPeer, MutantsOfItsFilesAreReadOrRefused) {
  if (const std::string missing = missing_peer(); !missing.empty()) {
    GTEST_SKIP() << "no peer: " << missing;
  }
  const test::ScratchDirectory scratch;
  const std::string path = scratch.file("peer.tdms");
  write("write_tdms.py", "'" + path + "' 3");
  const auto read = [](const std::string& bytes) {
    return ingest::measurement::parse_tdms(bytes, "run.tdms");
  };
  test::expect_mutants_answered(read, read_file(path), 500);
}

}  // namespace
}  // namespace tribolog::measurement_peer_test
