#include "cli/commands.h"

#include <CLI/CLI.hpp>

namespace tribolog::cli {

AddedCommands add_commands(CLI::App& to, const std::vector<AddCommand>& commands) {
  AddedCommands added;
  for (const AddCommand add : commands) {
    Run run = add(to);
    added.emplace_back(to.get_subcommands({}).back(), std::move(run));
  }
  return added;
}

std::optional<ExitStatus> run_chosen(const AddedCommands& commands, const Invocation& call) {
  for (const auto& [command, run] : commands) {
    if (*command) return run(call);
  }
  return std::nullopt;
}

}  // namespace tribolog::cli
