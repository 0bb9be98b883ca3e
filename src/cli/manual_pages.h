#pragma once
// The manual, made from the commands and their options.

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace tribolog::cli {

struct ManualPage {
  std::string name;  ///< "tribolog-archive-list.1"
  std::string text;  ///< For man, in its macros.
};

/// One of the program, and one of each command.
/// @param version of the program, which each names.
std::vector<ManualPage> manual_pages(const CLI::App& program, const std::string& version);

/// What the manual says of the command and of all below it, as Markdown, without exit statuses.
std::string command_reference(const CLI::App& command);

}  // namespace tribolog::cli
