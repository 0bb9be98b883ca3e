// Each public header compiles alone, without a warning and without anything of ours or of other
// libraries beside it.

#include <cstddef>
#include <filesystem>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "support/run_program.h"

namespace tribolog::test::headers_test {
namespace {

TEST(PublicHeaders, CompileAlone) {
  const ScratchDirectory scratch;
  const std::string include = scratch.file("include");
  std::filesystem::create_directory(include);
  std::filesystem::copy(TRIBOLOG_SOURCE_DIR "/src/api/tribolog", include + "/tribolog");
  std::size_t headers = 0;
  for (const auto& entry : std::filesystem::directory_iterator(include + "/tribolog")) {
    const std::string name = entry.path().filename().string();
    const std::string source = scratch.write(
        name + ".cpp", fmt::format("#include <tribolog/{0}>\n#include <tribolog/{0}>\n", name));
    const ProgramRun run = run_shell(
        fmt::format("'{}' -std=c++20 -Wall -Wextra -pedantic -Wshadow -Wconversion -Werror "
                    "-fsyntax-only -I'{}' '{}'",
                    TRIBOLOG_CXX, include, source));
    EXPECT_EQ(run.status, 0) << name << run.err;
    const ProgramRun all =
        run_shell(fmt::format("'{}' -std=c++20 -M -I'{}' '{}'", TRIBOLOG_CXX, include, source));
    for (const char* other : {"eigen", "Eigen", "vtk", "nlohmann", "fmt/", "boost"}) {
      EXPECT_EQ(all.out.find(other), std::string::npos) << name << " includes " << other;
    }
    ++headers;
  }
  EXPECT_GE(headers, 8U);
}

TEST(TheLibrarysPage, ShowsCodeThatCompiles) {
  const std::string page = read_text(TRIBOLOG_SOURCE_DIR "/docs/library.md");
  const std::string begin = "```cpp\n#include <tribolog/tribolog.h>\n";
  const std::size_t from = page.find(begin);
  ASSERT_NE(from, std::string::npos);
  const std::size_t code = from + begin.size();
  const ScratchDirectory scratch;
  const std::string source =
      scratch.write("page.cpp", "#include <tribolog/tribolog.h>\nint main() {\n" +
                                    page.substr(code, page.find("```", code) - code) + "}\n");
  const ProgramRun run = run_shell(fmt::format("'{}' -std=c++20 -fsyntax-only -I'{}/src/api' '{}'",
                                               TRIBOLOG_CXX, TRIBOLOG_SOURCE_DIR, source));
  EXPECT_EQ(run.status, 0) << run.err;
}

}  // namespace
}  // namespace tribolog::test::headers_test
