// README.md and the pages of docs/ as a newcomer types them: every command that a page shows is
// run, in its order, and what the page says that a run prints is what it prints.

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "cli/close_texts.h"
#include "cli/small_dataset.h"
#include "support/breadth.h"

namespace tribolog::test::readme_test {
namespace {

namespace fs = std::filesystem;

const std::string source = TRIBOLOG_SOURCE_DIR;

/// README.md and docs/*.md, by their path.
std::vector<std::string> pages() {
  std::vector<std::string> all{"README.md"};
  for (const auto& entry : fs::directory_iterator(source + "/docs")) {
    if (entry.path().extension() == ".md")
      all.push_back("docs/" + entry.path().filename().string());
  }
  std::sort(all.begin() + 1, all.end());
  return all;
}

struct Typed {
  std::string line;
  bool shows_output{};
  std::string shown;  ///< Where its output is shown.
};

/// "END" of a line that ends in <<'END': what follows is its input, up to the line that says so.
std::string end_of_input(const std::string& line) {
  const std::size_t at = line.find("<<'");
  return at == std::string::npos ? "" : line.substr(at + 3, line.find('\'', at + 3) - at - 3);
}

/// The commands of the page's blocks, without comments behind them; long ones in one line.
std::vector<Typed> commands_of(const std::string& page) {
  std::istringstream text(read_text(source + "/" + page));
  std::vector<Typed> commands;
  std::string kind;
  std::string input_end;
  bool goes_on = false;
  for (std::string line; std::getline(text, line);) {
    if (line.starts_with("```")) {
      kind = kind.empty() ? line : "";
      continue;
    }
    if (!input_end.empty()) {
      commands.back().line += "\n" + line;
      if (line == input_end) input_end.clear();
      continue;
    }
    const bool is_typed = kind == "```sh" || (kind == "```console" && line.starts_with("$ "));
    if (kind == "```console" && !is_typed && !commands.empty())
      commands.back().shown += line + "\n";
    if (!is_typed) continue;
    std::string command = line.substr(kind == "```sh" ? 0 : 2);
    command.resize(std::min(command.size(), command.find("  #")));
    if (goes_on) {
      commands.back().line += command;
    } else if (!command.empty() && command.front() != '#') {
      commands.push_back({command, kind == "```console", ""});
    }
    input_end = end_of_input(command);
    goes_on = !commands.empty() && commands.back().line.ends_with('\\');
    if (goes_on) commands.back().line.pop_back();
  }
  return commands;
}

/// What builds, installs or tests the program, or opens what it wrote.
bool is_about_the_checkout(std::string_view line) {
  constexpr std::array<std::string_view, 7> beginnings = {
      "./setup.sh ",   "./examples/run.sh", "./tests/run.sh", "apt-get ",
      "sudo apt-get ", "cmake --install ",  "python3 docs/"};
  return std::any_of(beginnings.begin(), beginnings.end(),
                     [&](std::string_view one) { return line.starts_with(one); });
}

/// A folder as the pages suppose it: the examples in it, and `tribolog` on the PATH.
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

/// Ids differ from machine to machine: the pages' stands for the first one that is archived.
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

/// A plan simulates for half a minute, and each report identifies six simulations, unless they are
/// told to do less: where no output is shown, they are. Each night all is done as it is typed.
std::string with_few_runs(const Typed& command) {
  std::string line = command.line;
  if (every_case()) return line;
  const std::string plan = "tribolog plan ";
  const std::string report = "tribolog report ";
  if (line.starts_with(plan)) line.insert(plan.size(), "--runs 2 ");
  const std::size_t at = line.rfind(report);
  const bool is_report = at == 0 || (at != std::string::npos && line[at - 1] == '\n');
  if (is_report && !command.shows_output) line.insert(at + report.size(), "--truth-runs 0 ");
  return line;
}

class Readme : public testing::TestWithParam<std::string> {};

TEST_P(Readme, ShowsCommandsThatCanBeTypedAsTheyAre) {
  const Newcomer newcomer;
  for (const Typed& command : commands_of(GetParam())) {
    if (is_about_the_checkout(command.line)) continue;
    const ProgramRun run = newcomer.types(with_own_id(with_few_runs(command), newcomer));
    EXPECT_EQ(run.status, 0) << command.line << "\n" << run.err;
    if (!command.shows_output) continue;
    EXPECT_FALSE(command.shown.empty()) << command.line;
    EXPECT_EQ(difference(run.out, command.shown, 1e-3), "") << command.line;
  }
}

/// "docs/real_logs.md" as "docs_real_logs": what a test may be called.
std::string name_of_page(const testing::TestParamInfo<std::string>& page) {
  std::string name = page.param.substr(0, page.param.rfind('.'));
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
  return name;
}

/// Those that show commands.
std::vector<std::string> pages_with_commands() {
  std::vector<std::string> all = pages();
  std::erase_if(all, [](const std::string& page) { return commands_of(page).empty(); });
  return all;
}

INSTANTIATE_TEST_SUITE_P(Pages, Readme, testing::ValuesIn(pages_with_commands()), name_of_page);

TEST(Pages, ShowCommands) { EXPECT_GE(pages_with_commands().size(), 7U); }

}  // namespace
}  // namespace tribolog::test::readme_test
