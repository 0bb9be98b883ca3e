// A thousand dialects, written by another program, come back to the last bit.

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "base/input_file.h"
#include "base/temporary_directory.h"
#include "ingest/text/csv_reader.h"
#include "support/run_program.h"

namespace tribolog::written_dialects_test {
namespace {

constexpr int dialects = 1000;

std::vector<std::string> split(const std::string& line, char mark) {
  std::vector<std::string> parts;
  std::istringstream in(line);
  for (std::string part; std::getline(in, part, mark);) parts.push_back(part);
  return parts;
}

/// @return what differs; empty: nothing.
std::string difference(const std::string& path) {
  std::ifstream expected(path + ".txt");
  std::string mark;
  std::string line;
  std::getline(expected, mark);
  std::getline(expected, line);
  const std::vector<std::string> names = split(line, '\x1f');
  ingest::text::TextLogRules rules;
  if (mark == "comma") rules.decimal_mark = ingest::text::DecimalMark::comma;
  std::vector<ingest::log::WantedColumn> wanted;
  for (std::size_t k = 0; k < names.size(); ++k) wanted.push_back({fmt::format("#{}", k + 1)});
  InputFileSource bytes(path + ".csv");
  const ingest::text::CsvTable table = ingest::text::read_csv(bytes, path, wanted, rules);
  for (std::size_t k = 0; k < names.size(); ++k) {
    if (table.header.at(k) != names[k]) return "name " + table.header[k] + " for " + names[k];
  }
  std::size_t row = 0;
  for (; std::getline(expected, line); ++row) {
    const std::vector<std::string> values = split(line, ' ');
    for (std::size_t k = 0; k < names.size(); ++k) {
      const double value = std::strtod(values.at(k).c_str(), nullptr);
      const double found = row < table.rows ? table.columns[k].values[row] : HUGE_VAL;
      if (found == value || (std::isnan(found) && std::isnan(value))) continue;
      return fmt::format("row {}, column {}: {} for {}", row, k, found, value);
    }
  }
  return row == table.rows ? "" : fmt::format("{} rows for {}", table.rows, row);
}

TEST(WrittenDialects, AThousandOfPythonsComeBackToTheLastBit) {
  const test::TemporaryDirectory directory;
  const std::string script = TRIBOLOG_SOURCE_DIR "/tests/ingest/text/peer/write_dialects.py";
  const test::ProgramRun written =
      test::run_shell(fmt::format("python3 '{}' '{}' {}", script, directory.path(), dialects));
  if (written.status == 127) GTEST_SKIP() << "there is no Python";
  ASSERT_EQ(written.status, 0) << written.err;
  for (int i = 0; i < dialects; ++i) {
    const std::string path = directory.path(fmt::format("{:04}", i));
    try {
      ASSERT_EQ(difference(path), "") << "dialect " << i;
    } catch (const std::exception& refused) {
      FAIL() << "dialect " << i << ": " << refused.what();
    }
  }
}

}  // namespace
}  // namespace tribolog::written_dialects_test
