// README.md as a newcomer types it: every command that it shows is run, in its order.

#include <cstddef>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "cli/close_texts.h"
#include "cli/small_dataset.h"
#include "support/breadth.h"

namespace tribolog::test::readme_test {
namespace {

namespace fs = std::filesystem;

const std::string source = TRIBOLOG_SOURCE_DIR;

/// The lines of all blocks of a kind, without comments behind the commands.
std::vector<std::string> lines_of_blocks(const std::string& kind) {
  std::istringstream readme(read_text(source + "/README.md"));
  std::vector<std::string> lines;
  bool is_inside = false;
  for (std::string line; std::getline(readme, line);) {
    if (line.starts_with("```")) {
      is_inside = line == "```" + kind;
    } else if (is_inside) {
      lines.push_back(line.substr(0, line.find("  #")));
    }
  }
  return lines;
}

/// A folder as the README supposes it: the examples in it, and `tribolog` on the PATH.
class Newcomer {
 public:
  Newcomer() {
    fs::create_directory(scratch_.file("bin"));
    fs::create_symlink(TRIBOLOG_PROGRAM, scratch_.file("bin/tribolog"));
    fs::copy(source + "/examples", scratch_.file("examples"), fs::copy_options::recursive);
  }
  [[nodiscard]] ProgramRun types(const std::string& line) const {
    return run_shell("cd '" + scratch_.path() + "' && export PATH='" + scratch_.file("bin") +
                     "':$PATH HOME='" + scratch_.path() + "' XDG_DATA_HOME= && " + line);
  }

 private:
  ScratchDirectory scratch_;
};

/// Ids differ from machine to machine: the README's stands for the first one that is archived.
std::string with_own_id(std::string line, const Newcomer& newcomer) {
  const std::string shown = "02b2ab3c";
  const std::size_t at = line.find(shown);
  if (at == std::string::npos) return line;
  const ProgramRun list = newcomer.types(
      "tribolog archive list --json | grep -o '\"id\": *\"[0-9a-f]*' | head -1 | grep -o "
      "'[0-9a-f]*$'");
  EXPECT_GE(list.out.size(), shown.size()) << list.err;
  return line.replace(at, shown.size(), list.out.substr(0, shown.size()));
}

/// A plan simulates for half a minute unless it is told to do less; each night it does all.
std::string with_few_runs(std::string line) {
  if (!every_case() && line.starts_with("tribolog plan ")) line += " --runs 2";
  return line;
}

TEST(Readme, ShowsCommandsThatCanBeTypedAsTheyAre) {
  const Newcomer newcomer;
  std::size_t typed = 0;
  for (const std::string& line : lines_of_blocks("sh")) {
    if (!line.starts_with("tribolog ")) continue;  // what builds, installs or tests the program
    const ProgramRun run = newcomer.types(with_few_runs(with_own_id(line, newcomer)));
    EXPECT_EQ(run.status, 0) << line << "\n" << run.err;
    ++typed;
  }
  EXPECT_GE(typed, 10U);
}

// What it says that a run prints is what the run prints.
TEST(Readme, ShowsWhatIsPrinted) {
  const Newcomer newcomer;
  std::string printed;
  std::string shown;
  for (const std::string& line : lines_of_blocks("console")) {
    if (line.starts_with("$ ")) {
      const ProgramRun run = newcomer.types(line.substr(2));
      EXPECT_EQ(run.status, 0) << line << "\n" << run.err;
      printed += run.out;
    } else {
      shown += line + "\n";
    }
  }
  EXPECT_FALSE(shown.empty());
  EXPECT_EQ(difference(printed, shown, 1e-3), "");
}

}  // namespace
}  // namespace tribolog::test::readme_test
