#include <stdexcept>

#include <fmt/format.h>

#include "base/input_file.h"
#include "cli/commands.h"
#include "cli/shared_options.h"
#include "exports/simulation/simulation_files.h"
#include "ingest/manifest/scenario_file.h"
#include "ingest/manifest/toml_table.h"
#include "simulate/simulate_joint.h"
#include "wording/words.h"

namespace tribolog::cli {

namespace {

/// @throw InputError: numbers of which each is possible, and that together cannot be simulated.
std::vector<joint::Recording> simulated(const simulate::Scenario& scenario,
                                        const std::string& file) {
  try {
    return simulate::simulate_joint(scenario);
  } catch (const std::invalid_argument& error) {
    throw InputError(
        ingest::manifest::place_in_toml(read_file(file), file, "friction", "presliding"),
        {"cannot be simulated: " + wording::words(error), "", "",
         "are all numbers in the units that their keys state?"});
  }
}

}  // namespace

ExitStatus run_simulate(const SimulateOptions& options, Console& console) {
  simulate::Scenario scenario = ingest::manifest::read_scenario(options.scenario);
  if (options.seed) scenario.noise.seed = *options.seed;
  console.progress("simulating " + scenario.name, 0, 2);
  const std::vector<joint::Recording> recordings = simulated(scenario, options.scenario);
  console.progress("writing the recordings", 1, 2);
  exports::simulation::write_simulation(scenario, recordings, options.directory,
                                        {options.scenario});
  std::size_t samples = 0;
  for (const joint::Recording& recording : recordings) samples += recording.size();
  console.say(
      fmt::format("{}: {} recordings, {} samples", options.directory, recordings.size(), samples));
  return ExitStatus::done;
}

CLI::App& add_simulate(CLI::App& app, SimulateOptions& simulate) {
  CLI::App& command =
      *app.add_subcommand("simulate", "simulate a joint: recordings, manifest and true values");
  command.add_option("SCENARIO", simulate.scenario, "scenario file (TOML)")->required();
  command.add_option("-o,--output", simulate.directory, "directory to write to")->required();
  command.add_option("--seed", simulate.seed, "seed of the noise, instead of the scenario's")
      ->check(whole_number());
  command.footer(
      "\nWrites one CSV per recording, dataset.toml (for report) and truth.json.\n"
      "examples/paper/scenario.toml shows every key with its unit.");
  return command;
}

}  // namespace tribolog::cli
