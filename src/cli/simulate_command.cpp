#include <cstdint>
#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "base/input_file.h"
#include "cli/commands.h"
#include "cli/shared_options.h"
#include "exports/simulation/simulation_files.h"
#include "ingest/manifest/scenario_file.h"
#include "ingest/manifest/toml_table.h"
#include "simulate/robot_log.h"
#include "simulate/simulate_joint.h"
#include "wording/words.h"

namespace tribolog::cli {

namespace {

struct SimulateOptions {
  std::string scenario;
  std::string directory;
  std::optional<unsigned long long> seed;  ///< Instead of the scenario's.
};

/// @throw InputError: numbers of which each is possible, and that together cannot be simulated.
template <class Simulate>
auto simulated(const std::string& file, Simulate simulate) {
  try {
    return simulate();
  } catch (const std::invalid_argument& error) {
    throw InputError(
        ingest::manifest::place_in_toml(read_file(file), file, "friction", "presliding"),
        {"cannot be simulated: " + wording::words(error), "", "",
         "are all numbers in the units that their keys state?"});
  }
}

ExitStatus simulate_robot(std::vector<simulate::Scenario> joints, const SimulateOptions& options,
                          Console& console) {
  if (options.seed) {
    std::uint64_t seed = *options.seed;
    for (simulate::Scenario& joint : joints) joint.noise.seed = seed++;
  }
  console.progress("simulating " + joints.front().name, 0, 2);
  const simulate::RobotLog log =
      simulated(options.scenario, [&] { return simulate::simulate_robot(joints); });
  console.progress("writing the log", 1, 2);
  exports::simulation::write_robot_simulation(joints, log, options.directory, {options.scenario});
  console.say(fmt::format("{}: {} joints in one log, {} samples", options.directory, joints.size(),
                          log.t_s.size()));
  return ExitStatus::done;
}

ExitStatus run_simulate(const SimulateOptions& options, Console& console) {
  if (auto joints = ingest::manifest::read_robot_scenario(options.scenario); !joints.empty()) {
    return simulate_robot(std::move(joints), options, console);
  }
  simulate::Scenario scenario = ingest::manifest::read_scenario(options.scenario);
  if (options.seed) scenario.noise.seed = *options.seed;
  console.progress("simulating " + scenario.name, 0, 2);
  const std::vector<joint::Recording> recordings =
      simulated(options.scenario, [&] { return simulate::simulate_joint(scenario); });
  console.progress("writing the recordings", 1, 2);
  exports::simulation::write_simulation(scenario, recordings, options.directory,
                                        {options.scenario});
  std::size_t samples = 0;
  for (const joint::Recording& recording : recordings) samples += recording.size();
  console.say(
      fmt::format("{}: {} recordings, {} samples", options.directory, recordings.size(), samples));
  return ExitStatus::done;
}

}  // namespace

Run add_simulate(CLI::App& app) {
  const auto options = std::make_shared<SimulateOptions>();
  CLI::App& command =
      *app.add_subcommand("simulate", "simulate a joint: recordings, manifest and true values");
  command.add_option("SCENARIO", options->scenario, "scenario file (TOML)")->required();
  command.add_option("-o,--output", options->directory, "directory to write to")->required();
  command.add_option("--seed", options->seed, "seed of the noise, instead of the scenario's")
      ->check(whole_number());
  command.footer(
      "\nWrites one CSV per recording, dataset.toml (for report) and truth.json. A scenario with\n"
      "[[joints]] is a robot's: one log, robot.csv, with robot.toml (for report).\n"
      "examples/paper/scenario.toml shows every key with its unit.");
  return [options](const Invocation& call) { return run_simulate(*options, call.console); };
}

}  // namespace tribolog::cli
