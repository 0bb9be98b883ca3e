// Manual and completion name every command, and of each all options that its help names.

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <filesystem>
#include <iterator>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "cli/small_dataset.h"

namespace tribolog::test::guide_test {
namespace {

using Names = std::set<std::string>;

struct Help {
  std::vector<std::string> commands;
  Names options;  ///< "-o", "--output"
};

/// Names at the start of a line of help: "  -o,--output TEXT REQUIRED   report (HTML) to write".
void add_names(const std::string& line, Names& names) {
  std::istringstream words(line.substr(0, line.find(' ', 2)));
  for (std::string name; std::getline(words >> std::ws, name, ',');) names.insert(name);
}

Help help_of(const std::string& path) {
  std::istringstream text(run_shell(program + path + " --help").out);
  Help help;
  std::string part;
  for (std::string line; std::getline(text, line);) {
    const bool is_entry = line.starts_with("  ") && line.size() > 2 && line[2] != ' ';
    std::string upper = line;
    std::transform(upper.begin(), upper.end(), upper.begin(),
                   [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    if (upper == "OPTIONS:" || upper == "SUBCOMMANDS:") {  // by the version of CLI11
      part = upper;
    } else if (line == "Of logs:") {  // a group of options
      part = "OPTIONS:";
    } else if (line.empty()) {
      part.clear();
    } else if (is_entry && part == "OPTIONS:") {
      add_names(line, help.options);
    } else if (is_entry && part == "SUBCOMMANDS:") {
      help.commands.push_back(line.substr(2, line.find(' ', 2) - 2));
    }
  }
  return help;
}

/// Each command by its path, "" first, with what its help says.
std::vector<std::pair<std::string, Help>> all_commands(const std::string& path = "") {
  std::vector<std::pair<std::string, Help>> all{{path, help_of(path)}};
  for (const std::string& command : all.front().second.commands) {
    const auto below = all_commands(path.empty() ? command : path + " " + command);
    all.insert(all.end(), below.begin(), below.end());
  }
  return all;
}

/// What bash would offer behind these words.
Names offered_by_bash(const std::string& script, const std::string& words, const std::string& at) {
  const ProgramRun run =
      run_shell("bash -c 'source \"" + script + "\"; COMP_WORDS=(tribolog " + words + " \"" + at +
                "\"); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _tribolog; printf "
                "\"%s\\n\" \"${COMPREPLY[@]}\"'");
  EXPECT_EQ(run.err, "");
  Names names;
  std::istringstream lines(run.out);
  for (std::string line; std::getline(lines, line);) names.insert(line);
  return names;
}

std::string completion(const std::string& shell) {
  const ProgramRun run = run_shell(program + "completion " + shell);
  EXPECT_EQ(run.status, 0) << run.err;
  return run.out;
}

TEST(Guide, HelpListsCommandsAndOptions) {
  const auto commands = all_commands();
  EXPECT_GT(commands.size(), 25U);
  for (const auto& [path, help] : commands) {
    EXPECT_EQ(help.options.count("--help"), 1U) << path;
  }
  EXPECT_EQ(help_of("archive").commands.size(), 11U);
}

TEST(Guide, BashOffersEachCommandAndOption) {
  const ScratchDirectory scratch;
  const std::string script = scratch.write("tribolog.bash", completion("bash"));
  const Names above = help_of("").options;
  for (const auto& [path, help] : all_commands()) {
    Names options = help.options;
    options.insert(above.begin(), above.end());
    EXPECT_EQ(offered_by_bash(script, path, "-"), options) << path;
    if (help.commands.empty()) continue;
    EXPECT_EQ(offered_by_bash(script, path, ""), Names(help.commands.begin(), help.commands.end()))
        << path;
  }
}

TEST(Guide, BashOffersTheWordsThatAnOptionTakes) {
  const ScratchDirectory scratch;
  const std::string script = scratch.write("tribolog.bash", completion("bash"));
  EXPECT_EQ(offered_by_bash(script, "figures --format", "p"), (Names{"pdf", "png"}));
  EXPECT_EQ(offered_by_bash(script, "figures --format =", "s"), (Names{"svg"}));
  EXPECT_EQ(offered_by_bash(script, "-q init log.csv --effort-side", ""),
            (Names{"joint", "motor"}));
}

TEST(Guide, OtherShellsNameEachCommandAndOption) {
  const std::string zsh = completion("zsh");
  const std::string fish = completion("fish");
  for (const auto& [path, help] : all_commands()) {
    const std::string key = path.empty() ? "" : " " + path;
    for (const std::string& command : help.commands) {
      EXPECT_NE(
          fish.find("\"__tribolog_at '" + key + "'\" --no-files --arguments " + command + " "),
          std::string::npos)
          << path << ": " << command;
    }
    const std::size_t begin = zsh.find("    '" + key + "')\n      options=(");
    ASSERT_NE(begin, std::string::npos) << path;
    const std::string part = zsh.substr(begin, zsh.find(";;", begin) - begin);
    for (const std::string& option : help.options) {
      EXPECT_NE(part.find("'" + option + ":"), std::string::npos) << path << ": " << option;
      if (!option.starts_with("--")) continue;
      const std::string line = "\"__tribolog_at '" + key + "'\"";
      bool is_named = false;
      for (std::size_t at = fish.find(line); at != std::string::npos;
           at = fish.find(line, at + 1)) {
        const std::string rest = fish.substr(at, fish.find('\n', at) - at);
        is_named =
            is_named || rest.find(" --long-option " + option.substr(2) + " ") != std::string::npos;
      }
      EXPECT_TRUE(is_named) << path << ": " << option;
    }
  }
}

TEST(Guide, NoOtherShellIsKnown) { EXPECT_EQ(run_shell(program + "completion csh").status, 2); }

/// As man's source has it: every hyphen is one that can be searched for and copied.
std::string in_macros(const std::string& text) {
  std::string escaped;
  for (const char c : text) escaped += c == '-' ? std::string("\\-") : std::string(1, c);
  return escaped;
}

TEST(Guide, EachCommandHasAManualPageWithItsOptions) {
  const ScratchDirectory scratch;
  const ProgramRun run = run_shell(program + "manual '" + scratch.file("man1") + "'");
  ASSERT_EQ(run.status, 0) << run.err;
  std::size_t pages = 0;
  for (const auto& [path, help] : all_commands()) {
    std::string name = path.empty() ? "tribolog" : "tribolog-" + path;
    std::replace(name.begin(), name.end(), ' ', '-');
    const std::string file = scratch.file("man1/" + name + ".1");
    ASSERT_TRUE(std::filesystem::exists(file)) << file;
    ++pages;
    const std::string page = read_text(file);
    for (const std::string& option : help.options) {
      const std::string bold = in_macros(option);
      const bool is_named = page.find("\\fB" + bold + "\\fR") != std::string::npos ||
                            page.find("\\fB" + bold + ", ") != std::string::npos ||
                            page.find(", " + bold + "\\fR") != std::string::npos;
      EXPECT_TRUE(is_named) << name << ": " << option;
    }
    for (const std::string& command : help.commands) {
      EXPECT_NE(page.find("\\fB" + in_macros(command) + "\\fR\n"), std::string::npos)
          << name << ": " << command;
    }
  }
  const std::filesystem::directory_iterator files(scratch.file("man1"));
  EXPECT_EQ(static_cast<std::size_t>(std::distance(begin(files), end(files))), pages);
}

}  // namespace
}  // namespace tribolog::test::guide_test
