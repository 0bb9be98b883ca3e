#include "cli/command_line.h"

#include <iostream>
#include <map>

#include <CLI/CLI.hpp>

#include "cli/commands.h"

namespace tribolog {
namespace {

constexpr const char* overview = R"(Identification reports of robot joints from their logs.

A dataset manifest (TOML) names the robot, the joint, its gear ratio, what the
effort column is, and the recordings by role. From it tribolog finds the centre
of gravity, the surrogate mass, the friction hysteresis and the viscous curve,
says how sure it is of each, and writes one HTML report.

  tribolog simulate examples/paper/scenario.toml -o out/paper
  tribolog report out/paper/dataset.toml -o out/paper/report.html
)";

constexpr const char* exit_statuses = R"(
Exit status: 0 done; 1 the verdict fails and --fail-on asked for that, or a check
of the paper does not hold; 2 usage; 3 an input file is refused; 4 an output file
cannot be written (nothing was changed); 5 a figure could not be drawn (the
numbers are kept); 70 a fault of the program.)";

constexpr const char* manifest_help = R"(
The manifest says, for example:

  schema = "tribolog-dataset-1"
  [robot]
  name = "FANUC AM100iB"
  description = "arm.toml"      # optional: draws the arm, see am100ib.toml
  [joint]
  name = "J3"
  gear_ratio = 100
  [effort]                      # never guessed: it must be stated
  kind = "motor_current"        # or "motor_torque", "joint_torque"
  side = "motor"                # or "joint": where the torque acts
  torque_constant_Nm_A = 0.35   # for motor_current
  [columns]
  time   = { name = "t", unit = "s" }
  angle  = { name = "q", unit = "deg" }
  effort = { name = "i", unit = "A" }
  [[recording]]
  role = "rough_sweep"          # precise_sweep, oscillation, constant_speed, break_away
  file = "sweep.csv"

Each role may occur any number of times, and each is optional: what is absent
makes the stages that need it say so; the rest still runs.)";

const std::map<std::string, Verdict> verdicts{{"doubtful", Verdict::doubtful},
                                              {"not-identifiable", Verdict::not_identifiable}};

void add_fail_on(CLI::App& command, std::optional<Verdict>& fail_on) {
  command
      .add_option_function<std::string>(
          "--fail-on", [&fail_on](const std::string& word) { fail_on = verdicts.at(word); },
          "exit with status 1 at this verdict or a worse one: doubtful, not-identifiable")
      ->check(CLI::IsMember(verdicts))
      ->type_name("VERDICT");
}

void add_processes(CLI::App& command, int& processes) {
  command.add_option("-j,--processes", processes, "processes that draw figures")
      ->check(CLI::Range(1, 64))
      ->capture_default_str();
}

}  // namespace

ExitStatus run_command_line(int argc, char** argv) {
  CLI::App app{overview, "tribolog"};
  app.footer(exit_statuses);
  app.require_subcommand(0, 1);
  bool quiet = false;
  bool version = false;
  app.add_flag("-q,--quiet", quiet, "print errors only");
  app.add_flag("--version", version, "print the versions of the program and of what it stands on");
  app.fallthrough();

  SimulateOptions simulate;
  CLI::App* simulate_command =
      app.add_subcommand("simulate", "simulate a joint: recordings, manifest and the truth");
  simulate_command->add_option("SCENARIO", simulate.scenario, "scenario file (TOML)")->required();
  simulate_command->add_option("-o,--output", simulate.directory, "directory to write to")
      ->required();
  simulate_command->add_option("--seed", simulate.seed,
                               "seed of the noise, instead of the scenario's");
  simulate_command->footer(
      "\nWrites one CSV per recording, dataset.toml (for report) and truth.json.\n"
      "examples/paper/scenario.toml shows every key with its unit.");

  IdentifyOptions identify;
  CLI::App* identify_command =
      app.add_subcommand("identify", "identify a joint: numbers with intervals, as JSON");
  identify_command->add_option("DATASET", identify.dataset, "dataset manifest (TOML)")->required();
  identify_command->add_option("-o,--output", identify.output, "calibration file (JSON) to write")
      ->required();
  add_fail_on(*identify_command, identify.fail_on);
  identify_command->footer(manifest_help);

  FiguresOptions figures;
  CLI::App* figures_command = app.add_subcommand("figures", "draw the figures as PNG files");
  figures_command->add_option("DATASET", figures.dataset, "dataset manifest (TOML)")->required();
  figures_command->add_option("-o,--output", figures.directory, "directory to write to")
      ->required();
  add_processes(*figures_command, figures.processes);

  ReportOptions report;
  CLI::App* report_command =
      app.add_subcommand("report", "identify, draw, and write one HTML report");
  report_command->add_option("DATASET", report.dataset, "dataset manifest (TOML)")->required();
  report_command->add_option("-o,--output", report.output, "report (HTML) to write")->required();
  report_command->add_option("--calibration", report.calibration,
                             "where to write the numbers (JSON); default: beside the report");
  bool no_figures = false;
  report_command->add_flag("--no-figures", no_figures, "numbers and tables only");
  add_fail_on(*report_command, report.fail_on);
  add_processes(*report_command, report.processes);
  report_command->footer(
      std::string("\nThe numbers are written first, then the figures are drawn, then the report\n"
                  "replaces an older one in one step.\n") +
      manifest_help);

  CLI::App* models_command =
      app.add_subcommand("models", "list the friction models, or compare them in one page");
  ModelsOptions models;
  bool compare = false;
  models_command->add_flag("--compare", compare, "draw all of them side by side");
  models_command->add_option("-o,--output", models.output, "page (HTML) to write, with --compare");
  add_processes(*models_command, models.processes);

  CLI::App* paper_command =
      app.add_subcommand("paper", "regenerate the paper, and check it against its print");
  PaperOptions paper;
  paper_command->add_option("-o,--output", paper.output, "page (HTML) to write")->required();
  add_processes(*paper_command, paper.processes);
  paper_command->footer(
      "\nSimulates the paper's joint, identifies it, draws all figures, and holds every figure,\n"
      "table and equation against what is printed. Status 1 if a check does not hold.");

  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp& call) {
    app.exit(call);
    return ExitStatus::done;
  } catch (const CLI::ParseError& error) {
    throw UsageError(std::string(error.what()) + "; see tribolog --help");
  }
  Console console(quiet);
  const std::vector<std::string> arguments(argv, argv + argc);
  report.figures = !no_figures;
  if (version) return run_version(console);
  if (*simulate_command) return run_simulate(simulate, console);
  if (*identify_command) return run_identify(identify, arguments, console);
  if (*figures_command) return run_figures(figures, console);
  if (*report_command) return run_report(report, arguments, console);
  if (*models_command) {
    if (compare == models.output.empty()) {
      throw UsageError("tribolog models: --compare and -o FILE belong together; see its --help");
    }
    return run_models(models, arguments, console);
  }
  if (*paper_command) return run_paper(paper, arguments, console);
  std::cout << app.help();
  return ExitStatus::usage;
}

}  // namespace tribolog
