#include <fmt/format.h>

#include "cli/commands.h"
#include "export/simulation_files.h"
#include "ingest/manifest/scenario_file.h"
#include "simulate/simulate_joint.h"

namespace tribolog {

ExitStatus run_simulate(const SimulateOptions& options, Console& console) {
  Scenario scenario = read_scenario(options.scenario);
  if (options.seed) scenario.noise.seed = *options.seed;
  console.progress("simulating " + scenario.name, 0, 2);
  const std::vector<Recording> recordings = simulate_joint(scenario);
  console.progress("writing the recordings", 1, 2);
  write_simulation(scenario, recordings, options.directory, {options.scenario});
  std::size_t samples = 0;
  for (const Recording& recording : recordings) samples += recording.size();
  console.say(
      fmt::format("{}: {} recordings, {} samples", options.directory, recordings.size(), samples));
  return ExitStatus::done;
}

}  // namespace tribolog
