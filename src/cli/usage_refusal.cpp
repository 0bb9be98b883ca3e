#include "cli/usage_refusal.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/closest_match.h"
#include "base/shown_text.h"
#include "cli/command_tree.h"
#include "cli/given_files.h"
#include "inspect/files/file_kind.h"

namespace tribolog::cli {
namespace {

std::string joined(const std::string& what, const std::string& hint) {
  return hint.empty() ? what : what + "; " + hint;
}

std::vector<std::string> names_of_commands(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::App* const one : commands_of(command)) names.push_back(one->get_name());
  return names;
}

/// What other programs call it. Empty: nothing that is known here.
std::string command_by_other_name(std::string_view word) {
  static constexpr std::array others{
      std::pair{std::string_view("calibrate"), "identify"},
      std::pair{std::string_view("calibration"), "identify"},
      std::pair{std::string_view("analyse"), "report"},
      std::pair{std::string_view("analyze"), "report"},
      std::pair{std::string_view("html"), "report"},
      std::pair{std::string_view("run"), "report"},
      std::pair{std::string_view("plot"), "figures"},
      std::pair{std::string_view("draw"), "figures"},
      std::pair{std::string_view("convert"), "export"},
      std::pair{std::string_view("compare"), "archive diff"},
      std::pair{std::string_view("delete"), "archive remove"},
      std::pair{std::string_view("info"), "inspect"},
      std::pair{std::string_view("print"), "show"},
  };
  for (const auto& [other, command] : others) {
    if (word == other) return command;
  }
  return "";
}

/// A command of another one, `diff` of `archive`, by its whole path; empty: there is none.
std::string path_of_inner_command(const CLI::App& program, const std::string& word) {
  for (const CLI::App* const one : all_commands(program)) {
    if (one->get_name() == word && path_of(*one) != word) return path_of(*one);
  }
  return "";
}

/// "it is a manifest: tribolog report dataset.toml -o report.html"
std::string hint_of_file(const std::string& word) {
  const inspect::files::FileKind kind = inspect::files::kind_of_file(word);
  const std::string name = name_of(kind);
  const std::string command = command_for(kind, printable(quoted_for_shell(word), longest_path));
  return name.empty() || command.empty() ? "" : "it is " + name + ": " + command;
}

/// Of one that is misspelt as well.
std::string hint_of_inner_command(const CLI::App& program, const std::string& word) {
  std::vector<std::string> names;
  for (const CLI::App* const one : all_commands(program)) {
    if (path_of(*one).find(' ') != std::string::npos) names.push_back(one->get_name());
  }
  const std::string close = closest_match(word, names);
  return close.empty() ? ""
                       : "did you mean 'tribolog " + path_of_inner_command(program, close) + "'?";
}

/// What a word was probably meant to be, as a hint; empty: nothing is close.
std::string hint_of_command(const CLI::App& program, const CLI::App& command,
                            const std::string& word) {
  if (const std::string inner = path_of_inner_command(program, word); !inner.empty()) {
    return "did you mean 'tribolog " + inner + "'?";
  }
  const std::string other = command_by_other_name(word);
  if (!other.empty()) return "did you mean 'tribolog " + other + "'?";
  if (const std::string file = hint_of_file(word); !file.empty()) return file;
  const std::string close = did_you_mean(word, names_of_commands(command));
  return close.empty() ? hint_of_inner_command(program, word) : close;
}

/// Of several words the first that is close to a command.
std::string unknown_command(const CLI::App& program, const CLI::App& command,
                            const std::vector<std::string>& words) {
  const auto refusal = [&](const std::string& word, const std::string& hint) {
    return joined(fmt::format("{} is no command of {}", in_quotes(word), typed(command)), hint);
  };
  for (const std::string& word : words) {
    const std::string hint = hint_of_command(program, command, word);
    if (!hint.empty()) return refusal(word, hint);
  }
  return refusal(words.front(),
                 fmt::format("commands: {}", fmt::join(names_of_commands(command), ", ")));
}

std::string without_dashes(std::string name) {
  return name.substr(std::min(name.find_first_not_of('-'), name.size()));
}

/// "did you mean '--gear-ratio'?"
std::string close_option(const CLI::App& command, const std::string& name) {
  std::vector<std::string> names = long_names(command);
  for (std::string& one : names) one = without_dashes(one);
  const std::string close = closest_match(without_dashes(name), names);
  return close.empty() ? "" : "did you mean '--" + close + "'?";
}

std::string commands_with(const CLI::App& program, const std::string& option) {
  std::vector<std::string> paths;
  for (const CLI::App* const one : all_commands(program)) {
    if (one->get_option_no_throw(option) != nullptr) paths.push_back(path_of(*one));
  }
  return fmt::format("{}", fmt::join(paths, ", "));
}

std::string unknown_option(const CLI::App& program, const CLI::App& command,
                           const std::string& argument) {
  const std::string name = argument.substr(0, argument.find('='));
  if (find_option(command, name) != nullptr) {
    return fmt::format("{} is an option of {} and stands behind it", printable(name),
                       typed(command));
  }
  const std::string what = fmt::format("{} is no option of {}", in_quotes(name), typed(command));
  const std::string owners = name.size() > 1 ? commands_with(program, name) : "";
  if (!owners.empty()) return what + ", but of: " + owners;
  return joined(what, close_option(command, name));
}

std::string surplus_word(const CLI::App& command, const std::string& word) {
  std::vector<std::string> names;
  for (const CLI::Option* const one : positionals_of(command)) names.push_back(main_name(*one));
  if (names.empty()) {
    return fmt::format("{} is not expected: {} takes options alone", in_quotes(word),
                       typed(command));
  }
  return fmt::format("{} is one argument too many: {} takes {}", in_quotes(word), typed(command),
                     fmt::join(names, ", "));
}

/// Words that the parser had no place for, in the order in which they were typed.
std::string refusal_of_extras(const CLI::App& program, const CLI::App& command,
                              const std::vector<std::string>& extras) {
  std::vector<std::string> words;
  std::copy_if(extras.begin(), extras.end(), std::back_inserter(words),
               [](const std::string& one) { return !looks_like_option(one); });
  const auto option = std::find_if(extras.begin(), extras.end(), looks_like_option);
  if (!commands_of(command).empty() && !words.empty()) {
    return unknown_command(program, command, words);
  }
  if (option != extras.end()) return unknown_option(program, command, *option);
  return surplus_word(command, words.front());
}

/// What stands before the first of these words; empty: none of them stands there.
std::string before(const std::string& text, const std::string& word) {
  const std::size_t at = text.find(word);
  return at == std::string::npos ? "" : text.substr(0, at);
}

/// "-o,--output is missing: report (HTML) to write"
std::string missing(const CLI::App& command, const std::string& name) {
  const CLI::Option* const option = command.get_option_no_throw(name);
  if (option == nullptr) return name + " is required";
  const std::vector<std::string> names = names_of(*option);
  return fmt::format("{} is required: {}",
                     names.empty() ? main_name(*option) : fmt::format("{}", fmt::join(names, ", ")),
                     option->get_description());
}

std::string refusal_of_requirement(const CLI::App& command, const std::string& what) {
  if (what == "A subcommand is required") {
    return fmt::format("{} needs a command: {}", typed(command),
                       fmt::join(names_of_commands(command), ", "));
  }
  const std::string name = before(what, " is required");
  return name.empty() ? what : missing(command, name);
}

std::string refusal_of_count(const CLI::App& command, const std::string& what) {
  const std::string name = before(what, ":");
  const CLI::Option* const option = name.empty() ? nullptr : find_option(command, name);
  if (option == nullptr) return what;
  if (option->results().size() > 1) {
    return fmt::format("{} is given {} times, and can be given once", name,
                       option->results().size());
  }
  return fmt::format("{}: the value is missing: {}", name, option->get_description());
}

std::string refusal_of_pair(const std::string& what) {
  const std::string first = before(what, " excludes ");
  if (first.empty()) return what;
  return fmt::format("{} and {} exclude each other", first,
                     what.substr(first.size() + std::string_view(" excludes ").size()));
}

std::string words_of(const CLI::App& program, const CLI::App& command,
                     const CLI::ParseError& error) {
  const std::vector<std::string> extras = program.remaining(true);
  const bool is_value = error.get_name() == "ValidationError";
  if (!extras.empty() && !is_value) return refusal_of_extras(program, command, extras);
  if (error.get_name() == "RequiredError") return refusal_of_requirement(command, error.what());
  if (error.get_name() == "ArgumentMismatch") return refusal_of_count(command, error.what());
  if (error.get_name() == "ExcludesError") return refusal_of_pair(error.what());
  return error.what();
}

}  // namespace

UsageError refusal_of(const CLI::App& program, const CLI::ParseError& error) {
  const CLI::App& command = chosen_command(program);
  return UsageError(
      fmt::format("{}; see {} --help", words_of(program, command, error), typed(command)));
}

const CLI::App& command_named(const CLI::App& program, const std::vector<std::string>& path) {
  const CLI::App* command = &program;
  for (const std::string& word : path) {
    const std::vector<const CLI::App*> commands = commands_of(*command);
    const auto found = std::find_if(commands.begin(), commands.end(),
                                    [&](const CLI::App* one) { return one->check_name(word); });
    if (found == commands.end()) {
      throw UsageError(
          joined(unknown_command(program, *command, {word}), "see " + typed(*command) + " --help"));
    }
    command = *found;
  }
  return *command;
}

}  // namespace tribolog::cli
