#pragma once
// The words of a command line, as they were typed, made ready for the parser.

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace tribolog::cli {

/// The words behind the program's name. `report help` becomes `report --help`, unless a file of
/// that name is meant.
/// @throw UsageError: an option is given an empty value (a script's variable that is not set), or a
///        long name has one dash.
std::vector<std::string> arguments_to_parse(const CLI::App& program,
                                            std::vector<std::string> arguments);

/// Moves an option whose value may be left out behind the words that are no value of it: what is a
/// directory or a file and no archive is an argument of the command. `--archive=FILE` stays.
std::vector<std::string> with_values_told_apart(const CLI::App& program,
                                                const std::vector<std::string>& arguments);

}  // namespace tribolog::cli
