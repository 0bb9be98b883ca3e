#include <stdexcept>

#include <fmt/format.h>

#include "base/file_contents.h"
#include "cli/commands.h"
#include "export/dataset/simulation_files.h"
#include "ingest/manifest/scenario_file.h"
#include "ingest/manifest/toml_table.h"
#include "simulate/simulate_joint.h"

namespace tribolog {

namespace {

/// @throw InputError: numbers of which each is possible, and that together cannot be simulated.
std::vector<Recording> simulated(const Scenario& scenario, const std::string& file) {
  try {
    return simulate_joint(scenario);
  } catch (const std::invalid_argument& error) {
    throw InputError(place_in_toml(read_file(file), file, "friction", "presliding"),
                     {std::string("cannot be simulated: ") + error.what(), "", "",
                      "are all numbers in the units that their keys name?"});
  }
}

}  // namespace

ExitStatus run_simulate(const SimulateOptions& options, Console& console) {
  Scenario scenario = read_scenario(options.scenario);
  if (options.seed) scenario.noise.seed = *options.seed;
  console.progress("simulating " + scenario.name, 0, 2);
  const std::vector<Recording> recordings = simulated(scenario, options.scenario);
  console.progress("writing the recordings", 1, 2);
  write_simulation(scenario, recordings, options.directory, {options.scenario});
  std::size_t samples = 0;
  for (const Recording& recording : recordings) samples += recording.size();
  console.say(
      fmt::format("{}: {} recordings, {} samples", options.directory, recordings.size(), samples));
  return ExitStatus::done;
}

}  // namespace tribolog
