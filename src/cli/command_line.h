#pragma once
// The command line: which command, with which options.

#include "base/error.h"

namespace tribolog::cli {

/// Parses the arguments and runs the command.
/// @throw tribolog::Error for everything that the user has to know.
ExitStatus run_command_line(int argc, char** argv);

}  // namespace tribolog::cli
