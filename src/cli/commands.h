#pragma once
// The commands, one file each, and what each takes from the command line.

#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "base/error.h"
#include "cli/archiving.h"
#include "cli/console.h"
#include "cli/given_data.h"
#include "cli/identification.h"
#include "cli/log_proposal.h"
#include "joint/dataset.h"
#include "tribolog/figures.h"
#include "tribolog/values.h"
#include "wording/language.h"

namespace tribolog::cli {

struct SimulateOptions {
  std::string scenario;
  std::string directory;
  std::optional<unsigned long long> seed;  ///< Instead of the scenario's.
};

struct IdentifyArguments {
  GivenData given;
  DatasetChoice dataset;              ///< Found of what is given.
  std::string output;                 ///< Empty: beside the input.
  std::size_t truth_runs{0};          ///< Of the known-truth check; 0: none.
  std::optional<Verdict> fail_on;     ///< This verdict or a worse one is exit status 1.
  std::optional<std::uint64_t> seed;  ///< Wins over the manifest's.
  ArchivingOptions archiving;
};

struct FiguresOptions {
  DatasetChoice dataset;
  std::string directory;
  std::vector<FigureFormat> formats{FigureFormat::png};
  FigureStyle style{FigureStyle::report};
  wording::Language language;
  std::size_t truth_runs{0};  ///< Of the known-truth check, which has a figure of its own.
  int processes{2};
};

struct ReportOptions {
  GivenData given;
  DatasetChoice dataset;    ///< Found of what is given.
  std::string output;       ///< Empty: beside the input.
  std::string calibration;  ///< Empty: beside the report.
  std::size_t truth_runs{0};
  std::optional<Verdict> fail_on;
  std::optional<std::uint64_t> seed;  ///< Wins over the manifest's.
  int processes{2};
  bool figures{true};
  wording::Language language;
  ArchivingOptions archiving;
};

struct ShowOptions {
  std::string file;  ///< A report or another page (HTML), or a calibration (JSON).
  bool json{false};
};

struct ModelsOptions {
  bool compare{false};  ///< All of them side by side, in one page; else the list on the console.
  std::string output;   ///< That page (HTML): one is not without the other.
  int processes{2};
  wording::Language language;
};

struct PlanCommandOptions {
  std::string joint;     ///< File of the joint, or of a robot's joints (TOML).
  std::string of_robot;  ///< One joint of a robot's file, by name; empty: all, or the only one.
  std::string directory;
  /// Of the joint, from an earlier plan; of a robot the directory with its joints'; empty: none.
  std::string calibration;
  std::size_t runs{20};  ///< Simulations behind the expected intervals; 0: none.
  unsigned long long seed{1};
  std::size_t threads{0};  ///< 0: all cores.
  int processes{2};
  wording::Language language;
};

struct PaperOptions {
  std::string scenario;  ///< Empty: the paper's joint, which is built in.
  std::string output;    ///< The page (HTML).
  int processes{2};
  wording::Language language;
};

struct StudyCommandOptions {
  std::string scenario;  ///< Empty: the paper's joint with realistic noise, which is built in.
  std::string output;    ///< The page (HTML).
  std::string json;      ///< All numbers; empty: only within the page.
  /// Of each case; with `mixed` joints. None: as many as the study has by itself.
  std::optional<std::size_t> runs;
  unsigned long long seed{1};
  std::size_t threads{0};            ///< 0: all cores.
  std::vector<std::string> factors;  ///< Keys; none: all.
  bool misfit{false};     ///< On joints and logs that the method's model does not describe.
  bool sound{false};      ///< The same on joints that it does describe.
  bool mixed{false};      ///< On joints drawn at random, with many small effects at once.
  bool less_data{false};  ///< On sound joints of which less was recorded than one would wish.
  std::vector<std::string> disturbances;  ///< With `misfit`: keys; none: all.
  std::vector<std::string> joints;        ///< With `misfit`: keys; none: all.
  std::string logs;  ///< With these three: directory for the first run of each case or joint.
  int processes{2};
  wording::Language language;
};

struct InspectOptions {
  InspectedLogs logs;
  std::string json;  ///< All of it as JSON; empty: only the text.
};

struct InitOptions {
  InspectedLogs logs;
  std::string output;      ///< The manifest.
  bool all_joints{false};  ///< A robot's, with all joints in the logs.
  bool force{false};       ///< Replaces one that exists.
};

/// Says what logs hold, and proposes a manifest.
ExitStatus run_inspect(const InspectOptions& options, Console& console);
/// Writes the proposed manifest.
ExitStatus run_init(const InitOptions& options, Console& console);
/// @param arguments the whole command line, for the provenance.
ExitStatus run_simulate(const SimulateOptions& options, Console& console);
ExitStatus run_identify(const IdentifyArguments& options, const std::vector<std::string>& arguments,
                        Console& console);
ExitStatus run_figures(const FiguresOptions& options, Console& console);
ExitStatus run_report(const ReportOptions& options, const std::vector<std::string>& arguments,
                      Console& console);
/// Says what a report or a calibration says, from the file alone.
ExitStatus run_show(const ShowOptions& options, Console& console);
/// The calibration (JSON) that a report carries, or that the file is.
/// @throw UsageError: a page without one.
std::string calibration_in(const std::string& file);
/// Lists the friction models with what each can show, or compares them in one page.
ExitStatus run_models(const ModelsOptions& options, const std::vector<std::string>& arguments,
                      Console& console);
/// The experiment to run on a joint: table, figure, set points, manifest, expected intervals.
ExitStatus run_plan(const PlanCommandOptions& options, const std::vector<std::string>& arguments,
                    Console& console);
/// Regenerates the paper and checks it: status 1 if a check fails.
ExitStatus run_paper(const PaperOptions& options, const std::vector<std::string>& arguments,
                     Console& console);
/// Bias, scatter and coverage of the estimators over many simulated runs, as one page.
ExitStatus run_study_command(const StudyCommandOptions& options,
                             const std::vector<std::string>& arguments, Console& console);

// What each command takes from the command line: its subcommand with every option and its help.

/// Each adds the command to the program. @return it: true once it was the one chosen.
CLI::App& add_inspect(CLI::App& app, InspectOptions& inspect);
CLI::App& add_init(CLI::App& app, InitOptions& init);
CLI::App& add_simulate(CLI::App& app, SimulateOptions& simulate);
CLI::App& add_identify(CLI::App& app, IdentifyArguments& identify);
CLI::App& add_figures(CLI::App& app, FiguresOptions& figures);
CLI::App& add_report(CLI::App& app, ReportOptions& report);
CLI::App& add_show(CLI::App& app, ShowOptions& show);
CLI::App& add_models(CLI::App& app, ModelsOptions& models);
CLI::App& add_paper(CLI::App& app, PaperOptions& paper);
CLI::App& add_plan(CLI::App& app, PlanCommandOptions& plan);
CLI::App& add_study(CLI::App& app, StudyCommandOptions& study);

}  // namespace tribolog::cli
