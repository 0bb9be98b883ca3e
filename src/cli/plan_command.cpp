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
#include "inspect/files/file_kind.h"

namespace tribolog::cli {

namespace {

bool is_calibration(const std::string& file) {
  using inspect::files::FileKind;
  const FileKind kind = inspect::files::kind_of_file(file);
  return kind == FileKind::calibration || kind == FileKind::report;
}

ExitStatus run_plan(const PlanCommandOptions& options, const std::vector<std::string>& arguments,
                    Console& console) {
  JointInput joint;
  if (is_calibration(options.joint)) {
    if (!options.calibration.empty() || !options.of_robot.empty()) {
      throw UsageError(
          "plan of a report or calibration: --calibration and --joint are for a joint's file");
    }
    joint = joint_of_calibration(options.joint);
  } else {
    const std::string text = read_file(options.joint, ingest::manifest::largest_joint_bytes);
    const std::vector<std::string> joints = ingest::manifest::joints_to_plan(text, options.joint);
    if (!joints.empty() && options.of_robot.empty()) {
      return plan_robot(options, joints, arguments, console);
    }
    joint = joint_in_file(options, text, options.of_robot);
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
  report::experiments::PlanReport report = plan_of_joint(
      options, joint, provenance, [&] { console.progress("simulating the plan", 0, 1); });
  const std::size_t failed =
      add_plan_files(report, options.directory, options.language, renderer, files, console);
  if (joint.is_from_recordings) {
    files.add((folder / planned_joint_name).string(), joint.text);
  }
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
  command
      .add_option("JOINT", options->joint,
                  "file of the joint, or of a robot's joints (TOML); or a report or calibration: "
                  "what to record next")
      ->required();
  command.add_option("-o,--output", options->directory, "directory to write to")->required();
  command
      .add_option("--joint", options->of_robot,
                  "one joint of a whole robot's file, [[joints]], by its "
                  "name")
      ->type_name("NAME");
  command.add_option("--calibration", options->calibration,
                     "calibration or report of this joint, from an earlier plan; of a robot the "
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
      "\nFrom the joint's limits of angle, speed, acceleration and torque, and what is known of\n"
      "gravity, friction, encoder and ripple: the sweeps, oscillations, runs and ramps to carry\n"
      "out, and the intervals to expect, by simulation. Writes plan.html, plan.json,\n"
      "setpoints.csv (time, angle, speed; torque of the ramps) and dataset.toml, with which\n"
      "`tribolog report` reads the recorded log. What the limits do not allow is reported,\n"
      "with the number and what would help. examples/plan/joint.toml shows every key.\n\n"
      "Of a whole robot (examples/plan/robot.toml) each joint's files are in a directory of its\n"
      "own; index.html leads to them, and dataset.toml is the manifest of all of their logs.\n\n"
      "Of a report or a calibration: what to record next for the quantities that are not usable,\n"
      "within the angles, speeds and torques of its recordings. joint.toml, written beside the\n"
      "plan, states them: put the joint's own limits there, and plan again.");
  return [options](const Invocation& call) {
    return run_plan(*options, call.arguments, call.console);
  };
}

}  // namespace tribolog::cli
