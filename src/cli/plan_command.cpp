#include <filesystem>

#include "cli/commands.h"
#include "cli/drawing.h"
#include "export/plan/plan_dataset_toml.h"
#include "export/plan/plan_json.h"
#include "export/plan/plan_table.h"
#include "export/plan/set_points_csv.h"
#include "figures/plan_figure.h"
#include "files/atomic_file.h"
#include "files/file_contents.h"
#include "ingest/manifest/joint_file.h"
#include "report/plan_page.h"

namespace tribolog {
namespace {

constexpr std::uint64_t largest_calibration_bytes = std::uint64_t{1} << 28;

JointFacts facts_of(const PlanCommandOptions& options, const std::string& text) {
  JointFacts facts = parse_joint(text, options.joint);
  if (options.calibration.empty()) return facts;
  return with_calibration(std::move(facts),
                          read_file(options.calibration, largest_calibration_bytes),
                          options.calibration);
}

}  // namespace

ExitStatus run_plan(const PlanCommandOptions& options, const std::vector<std::string>& arguments,
                    Console& console) {
  PlanReport report;
  report.provenance = make_provenance(arguments);
  report.joint_text = read_file(options.joint, largest_joint_bytes);
  report.joint_file = command_line_text({options.joint});
  const JointFacts facts = facts_of(options, report.joint_text);
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
  render::FigureRenderer renderer(options.processes);  // starts while the plan is simulated
  report.plan = plan_experiment(facts);
  console.progress("simulating the plan", 0, 1);
  report.expected = expect_intervals(report.plan, {options.runs, options.seed, options.threads});

  // Also where nothing can be done: those of an older plan must not stay beside this one.
  files.add(in_folder("setpoints.csv"), set_points_csv(report.plan));
  files.add(in_folder("dataset.toml"), plan_dataset_toml(report.plan));
  files.add(in_folder("plan.json"), plan_json(report.plan, report.expected, report.provenance));
  const std::vector<ReportFigure> figures = plan_figures(report.plan);
  const std::vector<render::DrawnFigure> drawn = draw(renderer, figures, options.language, console);
  report.provenance.drawing = software_that_drew(drawn);
  files.add(page, plan_page(report, figures, drawn, options.language));
  files.commit();

  console.say("plan: " + plan_sentence(report.plan));
  for (const std::string& line : plan_lines(report.plan)) console.say(line);
  const std::vector<std::string> expected = expectation_lines(report.expected);
  if (!expected.empty()) console.say("expect, with 95 % intervals, on the assumed joint:");
  for (const std::string& line : expected) console.say(line);
  console.say("plan: " + page);
  return tell_failures(drawn, console) > 0 ? ExitStatus::figure_failed : ExitStatus::done;
}

}  // namespace tribolog
