#pragma once
// `--language` of the commands that write pages and figures.

#include <CLI/CLI.hpp>

#include "language/language.h"

namespace tribolog {

void add_language(CLI::App& command, Language& language);

}  // namespace tribolog
