#pragma once
// What `tribolog figures` is told on the command line.

#include <CLI/CLI.hpp>

#include "cli/commands.h"

namespace tribolog {

/// Dataset, directory, formats and style.
void add_figures(CLI::App& command, FiguresOptions& figures);

}  // namespace tribolog
