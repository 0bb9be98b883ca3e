#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "base/atomic_file.h"
#include "base/input_file.h"
#include "cli/commands.h"
#include "cli/joint_plan.h"
#include "cli/robot_commands.h"
#include "cli/shared_options.h"
#include "exports/experiment/plan_table.h"
#include "ingest/manifest/joint_file.h"

namespace tribolog::cli {

namespace {

ExitStatus run_plan(const PlanCommandOptions& options, const std::vector<std::string>& arguments,
                    Console& console) {
  const std::string text = read_file(options.joint, ingest::manifest::largest_joint_bytes);
  const std::vector<std::string> joints = ingest::manifest::joints_to_plan(text, options.joint);
  if (!joints.empty() && options.of_robot.empty()) {
    return plan_robot(options, joints, arguments, console);
  }
  const calibration::Provenance provenance = calibration::make_provenance(arguments);
  std::vector<std::string> inputs{options.joint};
  if (!options.calibration.empty()) inputs.push_back(options.calibration);
  AtomicFiles files;
  files.make_directory(options.directory);
  const std::filesystem::path folder(options.directory);
  for (const std::string& name : plan_file_names()) {
    check_output_can_be_written((folder / name).string(), inputs);
  }
  render::workers::FigureRenderer renderer(
      options.processes);  // starts while the plan is simulated
  report::experiments::PlanReport report =
      plan_of_joint(options, text, options.of_robot, provenance,
                    [&] { console.progress("simulating the plan", 0, 1); });
  const std::size_t failed =
      add_plan_files(report, options.directory, options.language, renderer, files, console);
  files.commit();

  console.say("plan: " + exports::experiment::plan_sentence(report.plan));
  for (const std::string& line : exports::experiment::plan_lines(report.plan)) console.say(line);
  const std::vector<std::string> expected = exports::experiment::expectation_lines(report.expected);
  if (!expected.empty()) console.say("expect, with 95 % intervals, on the assumed joint:");
  for (const std::string& line : expected) console.say(line);
  console.say("plan: " + (folder / plan_page_name).string());
  return failed > 0 ? ExitStatus::figure_failed : ExitStatus::done;
}

}  // namespace

Run add_plan(CLI::App& app) {
  const auto options = std::make_shared<PlanCommandOptions>();
  CLI::App& command =
      *app.add_subcommand("plan", "plan the experiment on a joint, and what to expect from it");
  constexpr std::size_t most = 10'000;
  command.add_option("JOINT", options->joint, "file of the joint, or of a robot's joints (TOML)")
      ->required();
  command.add_option("-o,--output", options->directory, "directory to write to")->required();
  command
      .add_option("--joint", options->of_robot,
                  "one joint of a whole robot's file, [[joints]], by its "
                  "name")
      ->type_name("NAME");
  command.add_option("--calibration", options->calibration,
                     "calibration (JSON) of this joint, from an earlier plan; of a robot the "
                     "directory that `report` or `identify` wrote");
  command
      .add_option("--runs", options->runs, "simulations behind the intervals to expect; 0: none")
      ->check(CLI::Range(std::size_t{0}, most))
      ->capture_default_str();
  command.add_option("--seed", options->seed, "seed of their noise")
      ->check(whole_number())
      ->capture_default_str();
  add_threads(command, options->threads);
  add_processes(command, options->processes);
  add_language(command, options->language);
  command.footer(
      "\nFrom the joint's limits of angle, speed, acceleration and torque, and what is known "
      "of\ngravity, friction, encoder and ripple: the sweeps, oscillations, runs and ramps to "
      "carry\nout, and the intervals to expect, by simulation. Writes options->html, "
      "plan.json,\nsetpoints.csv (time, angle, speed; torque of the ramps) and dataset.toml, with "
      "which\n`tribolog report` reads the recorded log. What the limits do not allow is "
      "reported,\nwith the number and what would help. examples/plan/joint.toml shows every "
      "key.\n\nOf a "
      "whole robot (examples/plan/robot.toml) each joint's files are in a directory of its\nown; "
      "index.html leads to them, and dataset.toml is the manifest of all of their logs.");
  return [options](const Invocation& call) {
    return run_plan(*options, call.arguments, call.console);
  };
}

}  // namespace tribolog::cli
