#pragma once
// A command line that could not be parsed, in words: what is wrong with it, what was probably
// meant, and whose help says more.

#include <string>

#include <CLI/CLI.hpp>

#include "base/error.h"

namespace tribolog::cli {

/// @param program after it threw the error.
UsageError refusal_of(const CLI::App& program, const CLI::ParseError& error);

/// The command of that path ("archive", "list").
/// @throw UsageError: there is none, with the closest.
const CLI::App& command_named(const CLI::App& program, const std::vector<std::string>& path);

}  // namespace tribolog::cli
