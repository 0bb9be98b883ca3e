// Parquet written by other implementations (npm packages hyparquet-writer and parquet-wasm, which
// is Apache's in Rust) comes back to the numbers of the CSV of the same rows. The packages are
// fetched into the build directory once; where that cannot be, the tests skip.

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "base/input_file.h"
#include "ingest/parquet/parquet_reader.h"
#include "ingest/text/csv_reader.h"
#include "support/run_program.h"
#include "wording/words.h"

namespace tribolog::parquet_peer_test {
namespace {

const std::string packages = TRIBOLOG_PARQUET_PACKAGES;
const std::string peer = TRIBOLOG_SOURCE_DIR "/tests/ingest/parquet/peer";

/// Written once for all tests.
struct Written {
  Written();
  test::ScratchDirectory scratch;
  std::string missing;  ///< Why there is no peer; empty: there is.
  std::string failure;
};

Written::Written() {
  const test::ProgramRun fetched =
      test::run_shell("'" TRIBOLOG_SOURCE_DIR "/tests/support/npm_packages.sh' '" + packages +
                      "' '" + peer + "/package.json'");
  if (fetched.status != 0) {
    missing = fetched.out + fetched.err;
    return;
  }
  const test::ProgramRun run = test::run_shell("PARQUET_PACKAGES='" + packages + "' node '" + peer +
                                               "/write_parquet.mjs' '" + scratch.path() + "'");
  if (run.status != 0) failure = run.err;
}

const Written& written() {
  static const Written all;
  return all;
}

ingest::text::CsvTable rows_of_csv() {
  using ingest::log::ColumnReading;
  const std::string path = written().scratch.file("rows.csv");
  std::vector<ingest::log::WantedColumn> wanted;
  for (const char* name : {"t", "q", "steps", "tau", "ticks", "long", "count", "flag", "half",
                           "single", "gapful", "word", "stamp"}) {
    wanted.push_back({name});
  }
  wanted[wanted.size() - 2].reading = ColumnReading::words;
  wanted.back().reading = ColumnReading::iso_time;
  InputFileSource bytes(path);
  return ingest::text::read_csv(bytes, path, wanted, {});
}

/// What stands there, the word itself for one.
std::string field(const ingest::log::LogColumn& column, std::size_t row) {
  const double value = column.values[row];
  if (std::isnan(value)) return "gap";
  if (column.reading == ingest::log::ColumnReading::words) {
    return column.words.at(static_cast<std::size_t>(value));
  }
  return std::to_string(std::nearbyint((column.origin - 1772352900 + value) * 1e6));
}

/// @param exact numbers, which have to be the same to the last bit.
std::string first_difference(const ingest::log::LogColumn& expected,
                             const ingest::log::LogColumn& found) {
  const bool exact = expected.reading == ingest::log::ColumnReading::number;
  for (std::size_t row = 0; row < expected.values.size(); ++row) {
    const double a = expected.values[row];
    const double b = found.values[row];
    const bool same = exact ? a == b || (std::isnan(a) && std::isnan(b))
                            : field(expected, row) == field(found, row);
    if (!same) return "row " + std::to_string(row) + ": " + std::to_string(b);
  }
  return "";
}

void expect_rows_of_csv(const ingest::text::CsvTable& expected,
                        const ingest::log::LogTable& table) {
  EXPECT_EQ(wording::words(table.notes), std::vector<std::string>{});
  ASSERT_EQ(table.rows, 3000U);
  ASSERT_EQ(table.columns.size(), expected.columns.size());
  for (std::size_t k = 0; k < table.columns.size(); ++k) {
    EXPECT_EQ(table.columns[k].header.full, expected.columns[k].header.full);
    EXPECT_EQ(table.columns[k].reading, expected.columns[k].reading);
    EXPECT_EQ(table.columns[k].gaps, expected.columns[k].gaps) << table.header[k];
    EXPECT_EQ(first_difference(expected.columns[k], table.columns[k]), "") << table.header[k];
  }
}

ingest::log::LogTable table_in(const std::string& form) {
  std::vector<ingest::log::LogTable> tables =
      ingest::parquet::read_parquet(written().scratch.file(form + ".parquet"));
  EXPECT_EQ(tables.size(), 1U);
  return std::move(tables.at(0));
}

TEST(ParquetOfPeers, HasTheRowsOfTheCsv) {
  if (!written().missing.empty()) GTEST_SKIP() << "no peer: " << written().missing;
  ASSERT_EQ(written().failure, "");
  const ingest::text::CsvTable expected = rows_of_csv();
  for (const char* form :
       {"hy_default", "hy_plain", "hy_pages", "hy_delta", "hy_texts", "wasm_uncompressed_1",
        "wasm_uncompressed_2", "wasm_snappy_1", "wasm_snappy_2", "wasm_gzip_1", "wasm_gzip_2",
        "wasm_brotli_1", "wasm_brotli_2", "wasm_zstd_1", "wasm_zstd_2", "wasm_lz4_raw_1",
        "wasm_lz4_raw_2"}) {
    SCOPED_TRACE(form);
    expect_rows_of_csv(expected, table_in(form));
  }
}

std::vector<double> nested_row(std::size_t i) {
  const auto number = static_cast<double>(i);
  const bool has_state = i % 10 != 9;
  const bool has_angles = i % 6 != 0;
  return {has_state && i % 4 != 3 ? number / 8 : NAN, has_state ? number : NAN,
          has_angles ? number : NAN, has_angles && i % 5 != 0 ? -number : NAN,
          has_angles ? number / 2 : NAN};
}

TEST(ParquetOfPeers, HasStructuresAndListsAsColumns) {
  if (!written().missing.empty()) GTEST_SKIP() << "no peer: " << written().missing;
  ASSERT_EQ(written().failure, "");
  for (const char* form : {"nested", "nested_wasm"}) {
    SCOPED_TRACE(form);
    const ingest::log::LogTable table = table_in(form);
    ASSERT_EQ(table.header,
              (std::vector<std::string>{"state.q", "state.n", "angles_0", "angles_1", "angles_2"}));
    EXPECT_EQ(
        wording::words(table.notes),
        std::vector<std::string>{"'some' is not read: its rows hold lists of 1 and of 2 elements"});
    ASSERT_EQ(table.rows, 3000U);
    for (std::size_t i = 0; i < table.rows; ++i) {
      const std::vector<double> expected = nested_row(i);
      for (std::size_t k = 0; k < expected.size(); ++k) {
        const double found = table.columns[k].values[i];
        ASSERT_TRUE(found == expected[k] || (std::isnan(found) && std::isnan(expected[k])))
            << "row " << i << " of " << table.header[k] << ": " << found;
      }
    }
  }
}

}  // namespace
}  // namespace tribolog::parquet_peer_test
