#include "cli/typed_arguments.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include <fmt/format.h>

#include "base/closest_match.h"
#include "base/error.h"
#include "cli/command_tree.h"
#include "inspect/files/file_kind.h"

namespace tribolog::cli {
namespace {

using inspect::files::FileKind;

/// The command that the words name so far. @return the same where the word names no command of its
/// own.
const CLI::App& command_at(const CLI::App& command, const std::string& word) {
  for (const CLI::App* const one : commands_of(command)) {
    if (one->check_name(word)) return *one;
  }
  return command;
}

/// Of all words, options between them or not.
const CLI::App& command_in(const CLI::App& program, const std::vector<std::string>& arguments) {
  const CLI::App* command = &program;
  for (const std::string& argument : arguments) {
    if (argument == "--") break;
    if (!looks_like_option(argument)) command = &command_at(*command, argument);
  }
  return *command;
}

[[noreturn]] void refuse_empty(const CLI::App& command, const CLI::Option& option) {
  throw UsageError(
      fmt::format("{}: the value is empty; state one, or leave the option out; see {} --help",
                  main_name(option), typed(command)));
}

/// The parser would take the next word for the value. @param next the argument behind; nullptr: it
/// is the last one.
void refuse_empty_value(const CLI::App& command, const std::string& argument,
                        const std::string* next) {
  const CLI::Option* const option = find_option(command, argument);
  if (option == nullptr || !takes_value(*option)) return;
  if (argument.starts_with("--") && argument.ends_with('=')) refuse_empty(command, *option);
  const bool is_empty_next =
      next != nullptr && next->empty() && argument.find('=') == std::string::npos;
  if (is_empty_next && value_is_optional(*option)) refuse_empty(command, *option);
}

/// "-output": the parser would read "-o" with the value "utput".
void refuse_long_name_behind_one_dash(const CLI::App& command, const std::string& argument) {
  if (argument.size() < 3 || argument.starts_with("--")) return;
  const std::string meant = "-" + argument.substr(0, argument.find('='));
  const std::vector<std::string> names = long_names(command);
  if (std::find(names.begin(), names.end(), meant) == names.end()) return;
  throw UsageError(fmt::format("{}: a long name has two dashes: {}; see {} --help",
                               in_quotes(argument), meant, typed(command)));
}

bool is_there(const std::string& file) {
  return inspect::files::kind_of_file(file) != FileKind::missing;
}

/// `report help`, and nothing else.
bool asks_for_help(const CLI::App& program, const std::vector<std::string>& arguments) {
  if (arguments.size() < 2 || arguments.back() != "help" || is_there("help")) return false;
  const CLI::App* command = &program;
  for (std::size_t k = 0; k + 1 < arguments.size(); ++k) {
    const CLI::App* const next = &command_at(*command, arguments[k]);
    if (next == command) return false;
    command = next;
  }
  return true;
}

/// A new archive is made where there is nothing, or an empty file.
bool may_be_archive(const std::string& word) {
  const FileKind kind = inspect::files::kind_of_file(word);
  return kind == FileKind::missing || kind == FileKind::empty || kind == FileKind::archive;
}

/// A `--archive` without a value, before words that do not belong to it.
bool has_no_value(const CLI::App& command, const std::string& argument, const std::string& next) {
  if (argument.find('=') != std::string::npos) return false;
  const CLI::Option* const option = find_option(command, argument);
  return option != nullptr && value_is_optional(*option) && !looks_like_option(next) &&
         !may_be_archive(next);
}

/// What the command reads stands in front already: the next word is then a value.
bool is_given_data(const std::vector<std::string>& words, std::size_t count) {
  return std::any_of(words.begin(), words.begin() + static_cast<std::ptrdiff_t>(count),
                     [](const std::string& word) {
                       const FileKind kind = inspect::files::kind_of_file(word);
                       return kind == FileKind::manifest || kind == FileKind::log;
                     });
}

}  // namespace

std::vector<std::string> arguments_to_parse(const CLI::App& program,
                                            std::vector<std::string> arguments) {
  const CLI::App& command = command_in(program, arguments);
  for (std::size_t k = 0; k < arguments.size() && arguments[k] != "--"; ++k) {
    const std::string* const next = k + 1 < arguments.size() ? &arguments[k + 1] : nullptr;
    refuse_empty_value(command, arguments[k], next);
    refuse_long_name_behind_one_dash(command, arguments[k]);
  }
  if (asks_for_help(program, arguments)) arguments.back() = "--help";
  return arguments;
}

std::vector<std::string> with_values_told_apart(const CLI::App& program,
                                                const std::vector<std::string>& arguments) {
  const CLI::App& command = command_in(program, arguments);
  std::vector<std::string> told_apart = arguments;
  for (std::size_t k = 0; k + 1 < told_apart.size() && told_apart[k] != "--"; ++k) {
    if (!has_no_value(command, told_apart[k], told_apart[k + 1])) continue;
    if (is_given_data(told_apart, k)) continue;
    while (k + 1 < told_apart.size() && !looks_like_option(told_apart[k + 1])) {
      std::swap(told_apart[k], told_apart[k + 1]);
      ++k;
    }
  }
  return told_apart;
}

}  // namespace tribolog::cli
