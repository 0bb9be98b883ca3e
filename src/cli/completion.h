#pragma once
// What a shell needs to complete the program's commands, options and the words that options take.

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace tribolog::cli {

/// "bash", "zsh", "fish"
const std::vector<std::string>& shells_with_completion();

/// A script in the shell's language, made from the commands and their options.
/// @param shell one of shells_with_completion().
std::string completion_script(const CLI::App& program, const std::string& shell);

}  // namespace tribolog::cli
