#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include <fmt/format.h>

#include "api/drawing.h"
#include "base/atomic_file.h"
#include "base/input_file.h"
#include "cli/commands.h"
#include "cli/drawing.h"
#include "cli/shared_options.h"
#include "exports/experiment/plan_files.h"
#include "exports/experiment/plan_table.h"
#include "figures/figure_csv.h"
#include "figures/plan_figure.h"
#include "ingest/manifest/joint_file.h"
#include "ingest/manifest/toml_table.h"
#include "report/plan_page.h"
#include "wording/language.h"
#include "wording/words.h"

namespace tribolog::cli {

namespace {

constexpr double fastest_usual_Hz = 10'000;
constexpr std::uint64_t largest_calibration_bytes = std::uint64_t{1} << 28;

joint::JointFacts facts_of(const PlanCommandOptions& options, const std::string& text) {
  joint::JointFacts facts = ingest::manifest::parse_joint(text, options.joint);
  if (options.calibration.empty()) return facts;
  return ingest::manifest::with_calibration(
      std::move(facts), read_file(options.calibration, largest_calibration_bytes),
      options.calibration);
}

/// Simulating more would take hours and all memory.
void refuse_endless(const plan::ExperimentPlan& plan, const std::string& text,
                    const std::string& file) {
  constexpr double most_samples = 3e6;
  const double rate_Hz = std::max(plan.joint.sample_rate_Hz, plan.joint.set_point_rate_Hz);
  if (plan.duration_s() * rate_Hz <= most_samples) return;
  const bool by_set_points = plan.joint.set_point_rate_Hz > plan.joint.sample_rate_Hz;
  const bool is_fast = rate_Hz > fastest_usual_Hz;
  const Location place =
      is_fast ? ingest::manifest::place_in_toml(
                    text, file, "log", by_set_points ? "set_point_rate_Hz" : "sample_rate_Hz")
              : ingest::manifest::place_in_toml(text, file, "joint", "speed_limit_deg_s");
  throw InputError(place, {"the plan has too many samples",
                           fmt::format("{:.4g} s at {:g} Hz", plan.duration_s(), rate_Hz),
                           fmt::format("no more than {:g} samples", most_samples),
                           "are sample_rate_Hz and set_point_rate_Hz right, and are range of "
                           "motion, speed_limit and acceleration_limit in their units?"});
}

[[noreturn]] void refuse_together(const std::invalid_argument& error, const std::string& text,
                                  const std::string& file) {
  throw InputError(ingest::manifest::place_in_toml(text, file, "joint", ""),
                   {"no plan can be made from this: " + wording::words(error), "", "",
                    "are all numbers in the units that their keys state?"});
}

/// @throw InputError: numbers of which each is possible, and of which together no plan comes.
plan::ExperimentPlan planned(const joint::JointFacts& facts, const std::string& text,
                             const std::string& file) {
  try {
    plan::ExperimentPlan plan = plan::plan_experiment(facts);
    refuse_endless(plan, text, file);
    return plan;
  } catch (const std::invalid_argument& error) {
    refuse_together(error, text, file);
  }
}

/// @throw InputError as planned().
plan::ExpectedIntervals expected(const plan::ExperimentPlan& plan,
                                 const PlanCommandOptions& options, const std::string& text) {
  try {
    return plan::expect_intervals(plan, {options.runs, options.seed, options.threads});
  } catch (const std::invalid_argument& error) {
    refuse_together(error, text, options.joint);
  }
}

}  // namespace

ExitStatus run_plan(const PlanCommandOptions& options, const std::vector<std::string>& arguments,
                    Console& console) {
  report::PlanReport report;
  report.provenance = calibration::make_provenance(arguments);
  report.joint_text = read_file(options.joint, ingest::manifest::largest_joint_bytes);
  report.joint_file = calibration::command_line_text({options.joint});
  const joint::JointFacts facts = facts_of(options, report.joint_text);
  std::vector<std::string> inputs{options.joint};
  if (!options.calibration.empty()) inputs.push_back(options.calibration);
  AtomicFiles files;
  files.make_directory(options.directory);
  const std::filesystem::path folder(options.directory);
  const auto in_folder = [&](const char* name) { return (folder / name).string(); };
  const std::string page = in_folder("plan.html");
  for (const char* name : {"plan.html", "plan.json", "setpoints.csv", "dataset.toml"}) {
    check_output_can_be_written(in_folder(name), inputs);
  }
  render::workers::FigureRenderer renderer(
      options.processes);  // starts while the plan is simulated
  report.plan = planned(facts, report.joint_text, options.joint);
  console.progress("simulating the plan", 0, 1);
  report.expected = expected(report.plan, options, report.joint_text);

  // Also where nothing can be done: those of an older plan must not stay beside this one.
  files.add(in_folder("setpoints.csv"), exports::experiment::set_points_csv(report.plan));
  files.add(in_folder("dataset.toml"), exports::experiment::plan_dataset_toml(report.plan));
  files.add(in_folder("plan.json"),
            exports::experiment::plan_json(report.plan, report.expected, report.provenance));
  const std::vector<figures::ReportFigure> figures =
      figures::figures_in(options.language, [&] { return figures::plan_figures(report.plan); });
  const std::vector<render::workers::DrawnFigure> drawn = draw(renderer, figures, console);
  report.provenance.drawing = api::software_that_drew(drawn);
  {
    const wording::WordsIn words(options.language);
    files.add(page, report::plan_page(report, figures, drawn, options.language));
  }
  files.commit();

  console.say("plan: " + exports::experiment::plan_sentence(report.plan));
  for (const std::string& line : exports::experiment::plan_lines(report.plan)) console.say(line);
  const std::vector<std::string> expected = exports::experiment::expectation_lines(report.expected);
  if (!expected.empty()) console.say("expect, with 95 % intervals, on the assumed joint:");
  for (const std::string& line : expected) console.say(line);
  console.say("plan: " + page);
  return tell_failures(drawn, console) > 0 ? ExitStatus::figure_failed : ExitStatus::done;
}

CLI::App& add_plan(CLI::App& app, PlanCommandOptions& plan) {
  CLI::App& command =
      *app.add_subcommand("plan", "plan the experiment on a joint, and what to expect from it");
  constexpr std::size_t most = 10'000;
  command.add_option("JOINT", plan.joint, "file of the joint (TOML)")->required();
  command.add_option("-o,--output", plan.directory, "directory to write to")->required();
  command.add_option("--calibration", plan.calibration,
                     "calibration (JSON) of this joint, from an earlier plan");
  command.add_option("--runs", plan.runs, "simulations behind the intervals to expect; 0: none")
      ->check(CLI::Range(std::size_t{0}, most))
      ->capture_default_str();
  command.add_option("--seed", plan.seed, "seed of their noise")
      ->check(whole_number())
      ->capture_default_str();
  add_threads(command, plan.threads);
  add_processes(command, plan.processes);
  add_language(command, plan.language);
  command.footer(
      "\nFrom the joint's limits of angle, speed, acceleration and torque, and what is known "
      "of\ngravity, friction, encoder and ripple: the sweeps, oscillations, runs and ramps to "
      "carry\nout, and the intervals to expect, by simulation. Writes plan.html, "
      "plan.json,\nsetpoints.csv (time, angle, speed; torque of the ramps) and dataset.toml, with "
      "which\n`tribolog report` reads the recorded log. What the limits do not allow is "
      "reported,\nwith the number and what would help. examples/plan/joint.toml shows every key.");
  return command;
}

}  // namespace tribolog::cli
