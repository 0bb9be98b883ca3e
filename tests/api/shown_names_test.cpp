// The shared library shows what the public headers declare, and nothing else.

#include <cstddef>
#include <regex>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "support/run_program.h"

namespace tribolog::test::shown_names_test {
namespace {

TEST(TheSharedLibrary, ShowsWhatTheHeadersDeclareAndNoMore) {
  const ProgramRun run = run_shell("nm -DC --defined-only '" TRIBOLOG_LIBRARY "'");
  ASSERT_EQ(run.status, 0) << run.err;
  std::string headers;
  for (const char* name :
       {"calibration", "dataset", "failure", "figures", "files", "report", "values"}) {
    headers += read_text(TRIBOLOG_SOURCE_DIR "/src/api/tribolog/" + std::string(name) + ".h");
  }
  std::istringstream lines(run.out);
  std::size_t shown = 0;
  for (std::string line; std::getline(lines, line);) {
    constexpr std::size_t before_name = 19;  // address, blank, kind, blank
    ASSERT_GT(line.size(), before_name);
    const std::string name = line.substr(before_name);
    if (name.find(" for tribolog::Failure") != std::string::npos) continue;
    // A function of the public namespace, or of a class in it.
    static const std::regex pattern(R"(tribolog::([A-Z]\w*::)?(~?\w+|operator=)[[(].*)");
    std::smatch parts;
    ASSERT_TRUE(std::regex_match(name, parts, pattern)) << name;
    EXPECT_NE(headers.find(parts[2].str() + "("), std::string::npos) << name;
    ++shown;
  }
  EXPECT_GE(shown, 30U);
}

}  // namespace
}  // namespace tribolog::test::shown_names_test
