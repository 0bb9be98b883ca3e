// plan of all joints in a robot's file: a directory for each, and a page that leads to them.

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "base/atomic_file.h"
#include "base/error.h"
#include "base/input_file.h"
#include "base/parallel_for.h"
#include "cli/joint_plan.h"
#include "cli/robot_commands.h"
#include "cli/robot_joints.h"
#include "exports/experiment/plan_files.h"
#include "exports/experiment/plan_table.h"
#include "ingest/manifest/joint_file.h"
#include "report/experiments/robot_plan_page.h"

namespace tribolog::cli {
namespace {

constexpr const char* robot_page_name = "index.html";
constexpr const char* robot_manifest_name = "dataset.toml";

struct JointToPlan {
  std::string name;
  std::string directory;                                  ///< Of its files, in that of the robot.
  std::string calibration;                                ///< Empty: none.
  std::optional<report::experiments::PlanReport> report;  ///< Absent: see refusal.
  std::string refusal;
  ExitStatus status{ExitStatus::done};  ///< Of the refusal.
};

/// @throw UsageError: calibrations are asked for, and there is none.
std::vector<JointToPlan> joints_of(const PlanCommandOptions& options,
                                   const std::vector<std::string>& joints) {
  const std::vector<std::string> directories = file_names_of(joints);
  const std::filesystem::path earlier(options.calibration);
  std::vector<JointToPlan> all;
  std::size_t with_calibration = 0;
  for (std::size_t k = 0; k < joints.size(); ++k) {
    JointToPlan one;
    one.name = joints[k];
    one.directory = directories[k];
    const std::string file = (earlier / (directories[k] + ".calibration.json")).string();
    if (!options.calibration.empty() && std::filesystem::exists(file)) {
      one.calibration = file;
      ++with_calibration;
    }
    all.push_back(std::move(one));
  }
  if (!options.calibration.empty() && with_calibration == 0) {
    throw UsageError(fmt::format(
        "--calibration {}: of a whole robot it is the directory with its joints' calibrations, {} "
        "and so on; --joint picks one joint",
        printable(options.calibration, longest_path), directories.front() + ".calibration.json"));
  }
  return all;
}

void plan_one(const PlanCommandOptions& options, const std::string& text,
              const calibration::Provenance& provenance, const Progress& progress,
              JointToPlan& joint) {
  PlanCommandOptions own = options;
  own.calibration = joint.calibration;
  try {
    progress("planning", 0, 1);
    joint.report = plan_of_joint(own, joint_in_file(own, text, joint.name), provenance,
                                 [&] { progress("simulating the plan", 0, 1); });
    progress("planned", 1, 1);
  } catch (const Error& error) {
    joint.refusal = error.what();
    joint.status = error.status();
    progress("refused", 1, 1);
  }
}

void tell_plans(const std::vector<JointToPlan>& joints, Console& console) {
  double duration_s = 0;
  for (const JointToPlan& joint : joints) {
    const std::string name = printable(joint.name);
    if (!joint.report) {
      console.say(name + ": refused");
      continue;
    }
    duration_s += joint.report->plan.duration_s();
    console.say(name + ": " + exports::experiment::plan_sentence(joint.report->plan));
  }
  console.say(fmt::format("all joints, one after the other: {}",
                          exports::experiment::duration_text(duration_s)));
}

}  // namespace

ExitStatus plan_robot(const PlanCommandOptions& options, const std::vector<std::string>& joints,
                      const std::vector<std::string>& arguments, Console& console) {
  const calibration::Provenance provenance = calibration::make_provenance(arguments);
  const std::string text = read_file(options.joint, ingest::manifest::largest_joint_bytes);
  std::vector<JointToPlan> all = joints_of(options, joints);
  AtomicFiles files;
  files.make_directory(options.directory);
  const std::filesystem::path folder(options.directory);
  std::vector<std::string> inputs{options.joint};
  for (const JointToPlan& joint : all) {
    if (!joint.calibration.empty()) inputs.push_back(joint.calibration);
  }
  const std::string page = (folder / robot_page_name).string();
  const std::string manifest = (folder / robot_manifest_name).string();
  for (const std::string& file : {page, manifest}) check_output_can_be_written(file, inputs);
  render::workers::FigureRenderer renderer(options.processes);  // starts while plans are simulated

  JointProgress progress(joints, console);
  parallel_for(
      all.size(),
      [&](std::size_t k) { plan_one(options, text, provenance, progress.of(k), all[k]); },
      options.threads);
  console.finish();

  std::size_t failed_figures = 0;
  ExitStatus status = ExitStatus::done;
  std::vector<report::experiments::RobotPlanJoint> shown;
  std::vector<exports::experiment::PlannedJoint> planned;
  for (JointToPlan& joint : all) {
    report::experiments::RobotPlanJoint& one = shown.emplace_back();
    one.name = joint.name;
    one.refusal = joint.refusal;
    if (!joint.report) {
      console.warn(printable(joint.name) + ": error: " + joint.refusal);
      status = std::max(status, joint.status);
      continue;
    }
    const std::string directory = (folder / joint.directory).string();
    files.make_directory(directory);
    for (const std::string& name : plan_file_names()) {
      check_output_can_be_written(directory + "/" + name, inputs);
    }
    failed_figures +=
        add_plan_files(*joint.report, directory, options.language, renderer, files, console);
    one.plan = &joint.report->plan;
    one.expected = &joint.report->expected;
    one.file = joint.directory + "/" + plan_page_name;
    planned.push_back({joint.directory, one.plan});
  }
  files.add(page, report::experiments::robot_plan_page(shown, provenance, options.language));
  files.add(manifest, exports::experiment::plan_robot_toml(planned));
  files.commit();
  tell_plans(all, console);
  console.say("robot: " + printable(page, longest_path));
  return failed_figures > 0 && status == ExitStatus::done ? ExitStatus::figure_failed : status;
}

}  // namespace tribolog::cli
