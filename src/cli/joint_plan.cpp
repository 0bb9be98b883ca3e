#include "cli/joint_plan.h"

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "api/drawing.h"
#include "calibration/read_calibration.h"
#include "cli/drawing.h"
#include "cli/given_files.h"
#include "exports/experiment/plan_files.h"
#include "figures/experiments/plan_figure.h"
#include "figures/figure_csv.h"
#include "ingest/manifest/joint_file.h"
#include "ingest/manifest/toml_table.h"
#include "wording/words.h"

namespace tribolog::cli {

namespace {

constexpr double fastest_usual_Hz = 10'000;

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
plan::ExperimentPlan planned(const JointInput& joint) {
  const std::string text = joint.stated_text();
  try {
    plan::PlanOptions options;
    options.roles = joint.roles;
    plan::ExperimentPlan plan = plan::plan_experiment(joint.facts, options);
    refuse_endless(plan, text, joint.file);
    return plan;
  } catch (const std::invalid_argument& error) {
    refuse_together(error, text, joint.file);
  }
}

/// @throw InputError as planned().
plan::ExpectedIntervals expected(const plan::ExperimentPlan& plan,
                                 const PlanCommandOptions& options, const JointInput& joint) {
  try {
    return plan::expect_intervals(plan, {options.runs, options.seed, options.threads});
  } catch (const std::invalid_argument& error) {
    refuse_together(error, joint.stated_text(), joint.file);
  }
}

}  // namespace

JointInput joint_in_file(const PlanCommandOptions& options, const std::string& text,
                         const std::string& joint) {
  JointInput made;
  made.file = options.joint;
  made.text = text;
  made.facts = ingest::manifest::parse_joint(text, options.joint, joint);
  if (options.calibration.empty()) return made;
  made.facts = ingest::manifest::with_calibration(
      std::move(made.facts), calibration_in(options.calibration), options.calibration);
  return made;
}

JointInput joint_of_calibration(const std::string& file) {
  const std::string json = calibration_in(file);
  JointInput made;
  made.file = file;
  made.facts = ingest::manifest::recorded_joint(json, file);
  std::vector<joint::Quantity> wanted;
  for (const calibration::Quantity& q : calibration::read_calibration(json, file).quantities) {
    const auto quantity = joint::quantity_of(q.name);
    if (quantity && q.verdict != calibration::Verdict::usable) wanted.push_back(*quantity);
  }
  made.roles = plan::roles_that_show(wanted);
  made.text = exports::experiment::joint_toml(made.facts);
  made.is_from_recordings = true;
  return made;
}

report::experiments::PlanReport plan_of_joint(const PlanCommandOptions& options,
                                              const JointInput& joint,
                                              const calibration::Provenance& provenance,
                                              const std::function<void()>& simulates) {
  report::experiments::PlanReport report;
  report.provenance = provenance;
  report.joint_text = joint.text;
  report.joint_file = calibration::command_line_text(
      {joint.is_from_recordings ? planned_joint_name : options.joint});
  report.plan = planned(joint);
  simulates();
  report.expected = expected(report.plan, options, joint);
  return report;
}

const std::vector<std::string>& plan_file_names() {
  static const std::vector<std::string> names{plan_page_name, "plan.json", "setpoints.csv",
                                              "dataset.toml"};
  return names;
}

std::size_t add_plan_files(report::experiments::PlanReport& report, const std::string& directory,
                           const wording::Language& language,
                           render::workers::FigureRenderer& renderer, AtomicFiles& files,
                           Console& console) {
  const std::filesystem::path folder(directory);
  const auto in_folder = [&](const std::string& name) { return (folder / name).string(); };
  // Also where nothing can be done: those of an older plan must not stay beside this one.
  files.add(in_folder("setpoints.csv"), exports::experiment::set_points_csv(report.plan));
  files.add(in_folder("dataset.toml"), exports::experiment::plan_dataset_toml(report.plan));
  files.add(in_folder("plan.json"),
            exports::experiment::plan_json(report.plan, report.expected, report.provenance));
  const std::vector<figures::ReportFigure> figures = figures::figures_in(
      language, [&] { return figures::experiments::plan_figures(report.plan); });
  const std::vector<render::workers::DrawnFigure> drawn = draw(renderer, figures, console);
  report.provenance.drawing = api::software_that_drew(drawn);
  {
    const wording::WordsIn words(language);
    files.add(in_folder(plan_page_name),
              report::experiments::plan_page(report, figures, drawn, language));
  }
  return tell_failures(drawn, console);
}

}  // namespace tribolog::cli
