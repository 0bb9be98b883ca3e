#include "cli/command_options.h"
#include "cli/shared_options.h"

namespace tribolog {

CLI::App& add_simulate(CLI::App& app, SimulateOptions& simulate) {
  CLI::App& command =
      *app.add_subcommand("simulate", "simulate a joint: recordings, manifest and the truth");
  command.add_option("SCENARIO", simulate.scenario, "scenario file (TOML)")->required();
  command.add_option("-o,--output", simulate.directory, "directory to write to")->required();
  command.add_option("--seed", simulate.seed, "seed of the noise, instead of the scenario's")
      ->check(whole_number());
  command.footer(
      "\nWrites one CSV per recording, dataset.toml (for report) and truth.json.\n"
      "examples/paper/scenario.toml shows every key with its unit.");
  return command;
}

}  // namespace tribolog
