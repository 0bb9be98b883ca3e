#include "cli/command_options.h"
#include "cli/shared_options.h"

namespace tribolog {

CLI::App& add_plan(CLI::App& app, PlanCommandOptions& plan) {
  CLI::App& command =
      *app.add_subcommand("plan", "plan the experiment on a joint, and what to expect of it");
  constexpr std::size_t most = 10'000;
  command.add_option("JOINT", plan.joint, "file of the joint (TOML)")->required();
  command.add_option("-o,--output", plan.directory, "directory to write to")->required();
  command.add_option("--calibration", plan.calibration,
                     "calibration (JSON) of this joint, from an earlier plan");
  command
      .add_option("--runs", plan.runs,
                  "simulations behind the intervals to expect; 0: none are made")
      ->check(CLI::Range(std::size_t{0}, most))
      ->capture_default_str();
  command.add_option("--seed", plan.seed, "seed of their noise")
      ->check(whole_number())
      ->capture_default_str();
  add_threads(command, plan.threads);
  add_processes(command, plan.processes);
  add_language(command, plan.language);
  command.footer(
      "\nFrom the joint's limits of angle, speed, acceleration and torque, and what is known of\n"
      "gravity, friction, encoder and ripple: the sweeps, oscillations, runs and ramps to carry\n"
      "out, and the intervals to expect, by simulation. Writes plan.html, plan.json,\n"
      "setpoints.csv (time, angle, speed; torque of the ramps) and dataset.toml, with which\n"
      "`tribolog report` takes the log that is recorded. What the limits do not allow is said,\n"
      "with the number and what would help. examples/plan/joint.toml shows every key.");
  return command;
}

}  // namespace tribolog
