#pragma once
// The commands with their options, as they were added to the program: what help, completion and
// manual say, and what a typing error may have meant.

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace tribolog::cli {

/// "archive add"; empty of the program itself.
std::string path_of(const CLI::App& command);

/// "tribolog archive add", as it is typed.
std::string typed(const CLI::App& command);

/// The command that the parsed command line chose: of `archive add` the inner one, of none the
/// program.
const CLI::App& chosen_command(const CLI::App& program);

/// Those that help lists, in its order, without their own.
std::vector<const CLI::App*> commands_of(const CLI::App& command);

/// The program itself and all commands below it, each before its own.
std::vector<const CLI::App*> all_commands(const CLI::App& program);

/// In the order of help, without positional arguments.
std::vector<const CLI::Option*> options_of(const CLI::App& command);
std::vector<const CLI::Option*> positionals_of(const CLI::App& command);

/// "-o", "--output"; both for one that has both.
std::vector<std::string> names_of(const CLI::Option& option);

/// "--output", of an option without a long name "-o", of a positional argument its name.
std::string main_name(const CLI::Option& option);

/// The words of which it takes one; empty: it takes other values, or none.
std::vector<std::string> choices_of(const CLI::Option& option);

/// "FILE", "KIND", "NUMBER"; empty of one that takes no value.
std::string value_name(const CLI::Option& option);

bool takes_value(const CLI::Option& option);
/// As `--archive [LOCATION]`.
bool value_is_optional(const CLI::Option& option);

/// "-o" and "--output", but not "-", which is standard output.
bool looks_like_option(const std::string& argument);

/// The option that is meant by "-o", "--output" or "--output=x" within the command or above it;
/// nullptr: there is none.
const CLI::Option* find_option(const CLI::App& command, const std::string& argument);

/// The long names of its options, and of those that it takes from above, with their dashes.
std::vector<std::string> long_names(const CLI::App& command);

/// An option that takes any number of values takes one at each of its places, several only with
/// commas between them: the words behind are the command's arguments.
void take_one_value_each(CLI::App& program);

}  // namespace tribolog::cli
