#pragma once
// Commands that say what the program can do: `tribolog help`, `tribolog manifest`, `tribolog
// schema`, and two that help does not list and that packages are made with, `completion SHELL` and
// `manual DIRECTORY`.

#include <functional>

#include "cli/archive_commands.h"

namespace tribolog::cli {

/// Each adds its command. @return as add_archive(). @param app lives until the command has run.
std::function<Run()> add_help(CLI::App& app);
std::function<Run()> add_manifest(CLI::App& app);
std::function<Run()> add_schema(CLI::App& app);
std::function<Run()> add_completion(CLI::App& app);
std::function<Run()> add_manual(CLI::App& app);

}  // namespace tribolog::cli
