// Files with something wrong in them: read or refused in one line, never a crash.

#include <random>
#include <string>

#include <gtest/gtest.h>

#include "base/input_file.h"
#include "ingest/parquet/parquet_reader.h"
#include "support/breadth.h"
#include "support/damaged_files.h"
#include "support/parquet_writer.h"
#include "support/run_program.h"

namespace tribolog::parquet_damage_test {
namespace {

constexpr std::size_t mutants = 500;

const auto read = [](const std::string& bytes) {
  return ingest::parquet::parse_parquet(bytes, "a.parquet");
};

/// A bit turned over, bytes of elsewhere put in, a stretch cut out, or the end cut off: one to
/// three of these.
std::string mutant_of(const std::string& bytes, std::mt19937& random) {
  std::string changed = bytes;
  for (std::size_t times = 1 + random() % 3; times > 0 && changed.size() > 16; --times) {
    const std::size_t at = random() % changed.size();
    const std::size_t length = 1 + random() % 16;
    switch (random() % 4) {
      case 0:
        changed[at] = static_cast<char>(changed[at] ^ (1 << random() % 8));
        break;
      case 1:
        changed.insert(at, bytes.substr(random() % bytes.size(), length));
        break;
      case 2:
        changed.erase(at, length);
        break;
      default:
        if (random() % 8 == 0) changed.resize(at);
    }
  }
  return changed;
}

void expect_mutants_answered(const std::string& bytes) {
  std::mt19937 random(3);
  for (std::size_t i = 0; i < mutants; ++i) {
    test::expect_answer(read, mutant_of(bytes, random), "mutant " + std::to_string(i));
  }
}

/// Changes where they hurt: in the footer, which is small beside the pages of a real file.
void expect_footers_answered(const std::string& bytes, std::size_t footer_bytes) {
  std::mt19937 random(4);
  for (std::size_t i = 0; i < mutants; ++i) {
    std::string changed = bytes;
    for (int times = 0; times < 2; ++times) {
      const std::size_t at = bytes.size() - 1 - random() % footer_bytes;
      changed[at] = static_cast<char>(changed[at] ^ static_cast<char>(1 + random() % 255));
    }
    test::expect_answer(read, changed, "footer " + std::to_string(i));
  }
}

std::string small_file() {
  test::WrittenParquet file;
  test::add_doubles("t", {0, 1, 2, 3}, file);
  test::add_integers("n", {5, 6, 7, 8}, file);
  test::add_lists("q", {{1, 2}, {}, {3, 4}, {5, 6}}, file);
  file.schema.push_back({"word", 6, 1, 0, 0});
  test::WrittenColumn words{6, test::level_runs({{3, 1}, {1, 0}}) + "\x01\x03\x02", 4};
  words.encoding = 8;
  words.dictionary = std::string("\2\0\0\0up\4\0\0\0down", 14);
  words.dictionary_values = 2;
  file.columns.push_back(words);
  ++file.root_children;
  return test::write_parquet(file);
}

TEST(DamagedParquet, OfOurOwnIsReadOrRefused) {
  const std::string bytes = small_file();
  ASSERT_NO_THROW(read(bytes));
  expect_mutants_answered(bytes);
  expect_footers_answered(bytes, 200);
  test::expect_cuts_answered(read, bytes, 200);
  test::expect_changes_answered(read, bytes, 2000);
}

/// By other writers, compressed and in every encoding.
TEST(DamagedParquet, OfPeersIsReadOrRefused) {
  const std::string packages = TRIBOLOG_PARQUET_PACKAGES;
  const std::string peer = TRIBOLOG_SOURCE_DIR "/tests/ingest/parquet/peer";
  const test::ProgramRun fetched =
      test::run_shell("'" TRIBOLOG_SOURCE_DIR "/tests/support/npm_packages.sh' '" + packages +
                      "' '" + peer + "/package.json'");
  if (fetched.status != 0) GTEST_SKIP() << "no peer: " << fetched.out;
  const test::ScratchDirectory scratch;
  const test::ProgramRun run =
      test::run_shell("PARQUET_ROWS=60 PARQUET_PACKAGES='" + packages + "' node '" + peer +
                      "/write_parquet.mjs' '" + scratch.path() + "'");
  ASSERT_EQ(run.status, 0) << run.err;
  for (const std::string form : {"hy_delta", "hy_texts", "hy_default", "nested", "wasm_snappy_1",
                                 "wasm_zstd_2", "wasm_lz4_raw_1", "wasm_brotli_2"}) {
    SCOPED_TRACE(form);
    const std::string bytes = read_file(scratch.file(form + ".parquet"));
    ASSERT_NO_THROW(read(bytes));
    expect_mutants_answered(bytes);
  }
}

}  // namespace
}  // namespace tribolog::parquet_damage_test
