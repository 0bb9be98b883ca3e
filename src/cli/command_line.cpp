#include "cli/command_line.h"

#include <iostream>
#include <map>

#include <CLI/CLI.hpp>

#include "cli/archive/archive_commands.h"
#include "cli/commands.h"
#include "cli/figures_options.h"
#include "cli/language_option.h"

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
numbers are kept); 6 the archive is damaged, locked or of a newer program; 70 a
fault of the program.)";

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
  kind = "motor_current"        # or "motor_torque", "joint_torque"; "target_torque": a
                                # controller's value; "none": the log has no torque, and what
                                # its motion shows is checked
  side = "motor"                # or "joint": where the torque acts
  torque_constant_Nm_A = 0.35   # for motor_current
  confirmed = true              # false: kind and side are a proposal; the report warns
  [columns]
  time   = { name = "t", unit = "s" }
  angle  = { name = "q", unit = "deg" }
  effort = { name = "i", unit = "A" }    # file = "tau.csv": where it stands in another file,
                                         # row by row; time = its time's name there
  [intervals]                   # optional: of the 95 % intervals by resampling
  resamples = 1000              # 0: closed forms alone
  seed = 1
  [[recording]]
  role = "rough_sweep"          # precise_sweep, oscillation, constant_speed, break_away
  file = "sweep.csv"
  [[limit]]                     # optional: what you accept; the report says whether it is kept
  quantity = "coulomb_joint_Nm" # a wrong name gets the list of them
  max = 15                      # max, min, half_width, half_width_percent
  [log]                         # optional: what a text log cannot tell itself
  decimal_comma = true
  skip_bad_rows = true          # damaged rows: leave out and count them, up to 1 %
  [[known_load]]                # optional: gravity of further axes, subtracted from the logs
  amplitude_Nm = 1.825          # at the joint: amplitude cos(sum of the angles + phase)
  angles = ["q1_rad", "q2_rad"] # columns of the log
  [known_gravity]               # optional: the joint's own, as by its design, to compare with
  amplitude_Nm = 38.465
  q_peak_deg = 90

Each role may occur any number of times, and each is optional: what is absent
makes the stages that need it say so; the rest still runs. README.md, "Your own
joint", describes every key.)";

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

void add_intervals(CLI::App& command, IntervalSettings& intervals) {
  command.add_option("--resamples", intervals.resamples,
                     "resamples of the bootstrap behind the intervals: " +
                         allowed_resamples_in_words() + "; default: the manifest's, or 1000");
  command.add_option("--seed", intervals.seed,
                     "seed of the resamples; default: the manifest's, or 1");
}

void add_archiving(CLI::App& command, ArchivingOptions& archiving) {
  constexpr double longest_s = 3600;
  command
      .add_option_function<std::vector<std::string>>(
          "--archive",
          [&archiving](const std::vector<std::string>& given) {
            archiving.location = given.empty() ? "" : given.front();
          },
          "keep the numbers and the report in this archive (a file, or postgresql://...); without "
          "a value, in the user's own")
      ->expected(0, 1)
      ->type_name("LOCATION");
  command.add_flag("--archive-inputs", archiving.inputs, "manifest and recordings too");
  command.add_flag("--archive-again", archiving.again,
                   "where the same inputs are archived already: keep this beside that");
  command
      .add_option("--wait", archiving.wait_s,
                  "seconds to wait while another process writes to the archive")
      ->check(CLI::Range(0.0, longest_s))
      ->capture_default_str();
}

/// An unset variable of a script is not meant to be the user's own archive, which `--archive` alone
/// means.
void refuse_empty_location(const std::vector<std::string>& arguments) {
  for (std::size_t k = 0; k < arguments.size(); ++k) {
    const bool is_next =
        arguments[k] == "--archive" && k + 1 < arguments.size() && arguments[k + 1].empty();
    if (is_next || arguments[k] == "--archive=")
      throw UsageError("--archive: the location is empty");
  }
}

void add_processes(CLI::App& command, int& processes) {
  command.add_option("-j,--processes", processes, "processes that draw figures")
      ->check(CLI::Range(1, 64))
      ->capture_default_str();
}

void add_truth_runs(CLI::App& command, std::size_t& truth_runs) {
  constexpr std::size_t most = 10'000;
  command
      .add_option("--truth-runs", truth_runs,
                  "simulations of what was identified, each identified again; 0: no such check")
      ->check(CLI::Range(std::size_t{0}, most))
      ->capture_default_str();
}

const std::map<std::string, Side> sides{{"motor", Side::motor}, {"joint", Side::joint}};

void add_inspected_logs(CLI::App& command, InspectedLogs& logs) {
  command.add_option("FILE", logs.files, "logs of any format")->required();
  command.add_option("--joint", logs.known.joint,
                     "the joint, by its name in the logs; default: the one "
                     "that moves most");
  command.add_option("--gear-ratio", logs.known.gear_ratio, "motor angle / joint angle")
      ->check(CLI::PositiveNumber);
  command
      .add_option("--torque-constant", logs.known.torque_constant_Nm_A,
                  "N·m per ampere, of a motor current")
      ->check(CLI::PositiveNumber);
  command
      .add_option_function<std::string>(
          "--effort-side",
          [&logs](const std::string& word) { logs.known.effort_side = sides.at(word); },
          "side of the gear on which the effort acts: motor, joint")
      ->check(CLI::IsMember(sides))
      ->type_name("SIDE");
  command.add_option("--robot", logs.known.robot, "the robot's name");
  TextLogRules& rules = logs.known.log_rules;
  command.add_flag_callback(
      "--decimal-comma", [&rules] { rules.decimal_mark = DecimalMark::comma; },
      "text logs have decimal commas");
  command
      .add_option("--header-line", rules.header_line,
                  "line of the columns' names, where others stand in front of it")
      ->check(CLI::PositiveNumber);
  command.add_flag_callback(
      "--latin1", [&rules] { rules.encoding = TextEncoding::latin1; },
      "names in text logs are in Latin-1, not UTF-8");
}

void add_study(CLI::App& command, StudyCommandOptions& study) {
  constexpr std::size_t most = 1'000'000;
  command.add_option("SCENARIO", study.scenario,
                     "scenario file (TOML); default: the paper's joint with realistic noise");
  command.add_option("-o,--output", study.output, "page (HTML) to write")->required();
  command.add_option("--json", study.json, "file for all numbers (JSON)");
  command
      .add_option("--factor", study.factors,
                  "study this one alone (may be given again); default: all")
      ->check(CLI::IsMember({"torque_noise", "torque_step", "encoder", "ripple_one_position",
                             "ripple_eight_positions", "amplitude", "cycles"}));
  command.add_option("--runs", study.runs, "runs of each case")
      ->check(CLI::Range(std::size_t{2}, most))
      ->capture_default_str();
  command.add_option("--seed", study.seed, "seed of all noise")->capture_default_str();
  command.add_option("--threads", study.threads, "0: all cores; changes no number")
      ->check(CLI::Range(std::size_t{0}, std::size_t{1024}))
      ->capture_default_str();
  command
      .add_option("--resamples", study.resamples,
                  "bootstrap resamples in each run; 0: intervals in closed form")
      ->check(CLI::Range(std::size_t{0}, most))
      ->capture_default_str();
  add_processes(command, study.processes);
  add_language(command, study.language);
  command.footer(
      "\nSimulates the scenario again and again with noise of its own in each run, identifies "
      "each,\n"
      "and holds every estimator against the truth: bias, scatter, and coverage of the stated 95 "
      "%\n"
      "intervals, one factor at a time about the base case: white torque noise, torque step,\n"
      "encoder, ripple from one and from eight motor positions, amplitude and cycles of the\n"
      "oscillation. 200 runs of about thirty cases take some minutes on two cores; --runs 20\n"
      "shows the biases in seconds.");
}

void add_plan(CLI::App& command, PlanCommandOptions& plan) {
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
  command.add_option("--seed", plan.seed, "seed of their noise")->capture_default_str();
  command.add_option("--threads", plan.threads, "0: all cores; changes no number")
      ->check(CLI::Range(std::size_t{0}, std::size_t{1024}))
      ->capture_default_str();
  add_processes(command, plan.processes);
  add_language(command, plan.language);
  command.footer(
      "\nFrom the joint's limits of angle, speed, acceleration and torque, and what is known of\n"
      "gravity, friction, encoder and ripple: the sweeps, oscillations, runs and ramps to carry\n"
      "out, and the intervals to expect, by simulation. Writes plan.html, plan.json,\n"
      "setpoints.csv (time, angle, speed; torque of the ramps) and dataset.toml, with which\n"
      "`tribolog report` takes the log that is recorded. What the limits do not allow is said,\n"
      "with the number and what would help. examples/plan/joint.toml shows every key.");
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

  InspectOptions inspect;
  CLI::App* inspect_command =
      app.add_subcommand("inspect", "what a log holds: columns, clock, motion, a manifest for it");
  add_inspected_logs(*inspect_command, inspect.logs);
  inspect_command->add_option("--json", inspect.json, "file for all of it (JSON)");
  inspect_command->footer(
      "\nGuesses are marked as such. Speeds are slopes of the angle between marks of its travel;\n"
      "the logged speed is not trusted. A log that is refused does not keep the others from\n"
      "being shown; the exit status is 3 then.");

  InitOptions init;
  CLI::App* init_command = app.add_subcommand("init", "write the manifest that inspect proposes");
  add_inspected_logs(*init_command, init.logs);
  init_command->add_option("-o,--output", init.output, "manifest (TOML) to write")->required();
  init_command->add_flag("--force", init.force, "replace a manifest that exists");
  init_command->footer(
      "\nGear ratio and torque constant are seldom in a log: state them here, or in the file.\n"
      "Its comments say what was guessed.");

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

  IdentifyArguments identify;
  CLI::App* identify_command =
      app.add_subcommand("identify", "identify a joint: numbers with intervals, as JSON");
  identify_command->add_option("DATASET", identify.dataset, "dataset manifest (TOML)")->required();
  identify_command->add_option("-o,--output", identify.output, "calibration file (JSON) to write")
      ->required();
  add_truth_runs(*identify_command, identify.truth_runs);
  add_fail_on(*identify_command, identify.fail_on);
  add_intervals(*identify_command, identify.intervals);
  add_archiving(*identify_command, identify.archiving);
  identify_command->footer(manifest_help);

  FiguresOptions figures;
  CLI::App* figures_command =
      app.add_subcommand("figures", "draw the figures as PNG, SVG or PDF files");
  add_figures(*figures_command, figures);
  add_truth_runs(*figures_command, figures.truth_runs);
  add_processes(*figures_command, figures.processes);
  add_language(*figures_command, figures.language);

  ReportOptions report;
  CLI::App* report_command =
      app.add_subcommand("report", "identify, draw, and write one HTML report");
  report_command->add_option("DATASET", report.dataset, "dataset manifest (TOML)")->required();
  report_command->add_option("-o,--output", report.output, "report (HTML) to write")->required();
  report_command->add_option("--calibration", report.calibration,
                             "where to write the numbers (JSON); default: beside the report");
  bool no_figures = false;
  report_command->add_flag("--no-figures", no_figures, "numbers and tables only");
  add_truth_runs(*report_command, report.truth_runs);
  add_fail_on(*report_command, report.fail_on);
  add_intervals(*report_command, report.intervals);
  add_archiving(*report_command, report.archiving);
  add_processes(*report_command, report.processes);
  add_language(*report_command, report.language);
  report_command->footer(
      std::string("\nThe numbers are written first, then the figures are drawn, then the report\n"
                  "replaces an older one in one step.\n") +
      manifest_help);

  ShowOptions show;
  CLI::App* show_command =
      app.add_subcommand("show", "the numbers of a report, read from the report itself");
  show_command->add_option("FILE", show.file, "report (HTML) or calibration (JSON)")->required();
  show_command->add_flag("--json", show.json, "all of them as JSON, to standard output");
  show_command->footer(
      "\nEvery page of tribolog carries its numbers as JSON; --json gives them back as they\n"
      "are. Values are SI, torques at the motor.");

  CLI::App* models_command =
      app.add_subcommand("models", "list the friction models, or compare them in one page");
  ModelsOptions models;
  bool compare = false;
  models_command->add_flag("--compare", compare, "draw all of them side by side");
  models_command->add_option("-o,--output", models.output, "page (HTML) to write, with --compare");
  add_processes(*models_command, models.processes);
  add_language(*models_command, models.language);

  CLI::App* paper_command =
      app.add_subcommand("paper", "regenerate the paper, and check it against its print");
  PaperOptions paper;
  paper_command->add_option("-o,--output", paper.output, "page (HTML) to write")->required();
  add_processes(*paper_command, paper.processes);
  add_language(*paper_command, paper.language);
  paper_command->footer(
      "\nSimulates the paper's joint, identifies it, draws all figures, and holds every figure,\n"
      "table and equation against what is printed. Status 1 if a check does not hold.");

  CLI::App* plan_command =
      app.add_subcommand("plan", "plan the experiment on a joint, and what to expect of it");
  PlanCommandOptions plan;
  add_plan(*plan_command, plan);

  CLI::App* study_command =
      app.add_subcommand("study", "Monte-Carlo study: where the method can be trusted");
  StudyCommandOptions study;
  add_study(*study_command, study);

  const auto chosen_of_archive = cli::add_archive(app);
  const auto chosen_review = cli::add_review(app);
  refuse_empty_location({argv, argv + argc});

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
  if (*inspect_command) return run_inspect(inspect, console);
  if (*init_command) return run_init(init, console);
  if (*simulate_command) return run_simulate(simulate, console);
  if (*identify_command) return run_identify(identify, arguments, console);
  if (*figures_command) return run_figures(figures, console);
  if (*report_command) return run_report(report, arguments, console);
  if (*show_command) return run_show(show, console);
  if (*models_command) {
    if (compare == models.output.empty()) {
      throw UsageError("tribolog models: --compare and -o FILE belong together; see its --help");
    }
    return run_models(models, arguments, console);
  }
  if (*paper_command) return run_paper(paper, arguments, console);
  if (*plan_command) return run_plan(plan, arguments, console);
  if (const cli::Run run = chosen_of_archive()) return run({arguments, console});
  if (const cli::Run run = chosen_review()) return run({arguments, console});
  if (*study_command) return run_study_command(study, arguments, console);
  std::cout << app.help();
  return ExitStatus::usage;
}

}  // namespace tribolog
