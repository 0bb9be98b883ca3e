#include "cli/command_line.h"

#include <sstream>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "base/standard_output.h"
#include "calibration/provenance.h"
#include "cli/archive_commands.h"
#include "cli/commands.h"
#include "render/workers/renderer.h"
#include "wording/words.h"

namespace tribolog::cli {
namespace {

constexpr const char* overview = R"(Identification reports of robot joints from their logs.

A dataset manifest (TOML) names the robot, the joint, its gear ratio, what the
effort column is, and the recordings by role. From it tribolog finds the centre
of gravity, the surrogate mass, the friction hysteresis and the viscous curve,
states an uncertainty for each, and writes one HTML report.

  tribolog simulate examples/paper/scenario_noise.toml -o out/paper
  tribolog report out/paper/dataset.toml -o out/paper/report.html
)";

constexpr const char* exit_statuses = R"(
Exit status: 0 done; 1 the verdict fails and --fail-on was given, or a check
of the paper does not hold; 2 usage; 3 an input file is refused; 4 an output file
or standard output cannot be written (no file was changed, unless the message says
which are kept); 5 a figure could not be drawn (the numbers are kept); 6 the
archive is damaged, locked or from a newer program; 70 internal error, or out of
memory; 128 + n: ended by signal n (130: SIGINT, 143: SIGTERM).)";

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

/// From version 2.6 on CLI11 would break our lines anew, and take their indents away.
template <class Formatter>
void keep_lines_as_written(Formatter& formatter) {
  if constexpr (requires { formatter.enable_footer_formatting(false); }) {
    formatter.enable_description_formatting(false);
    formatter.enable_footer_formatting(false);
  }
}

/// @param verbose loads what draws, and names it as it runs
ExitStatus run_version(bool verbose, Console& console) {
  const calibration::Provenance p = calibration::make_provenance({});
  console.say(fmt::format("tribolog {} ({})", p.tool_version, p.git_revision));
  console.say(fmt::format("compiler {}", p.compiler));
  console.say(fmt::format("Eigen {}", p.eigen_version));
  try {
    const render::figure::RendererInfo info =
        verbose ? render::workers::renderer_info() : render::workers::built_renderer();
    console.say(fmt::format("VTK {} through {}", info.vtk_version, info.back_end));
    if (verbose)
      console.say(fmt::format("renderer {}, Mesa {}", info.gl_renderer, info.gl_version));
    console.say(fmt::format("FreeType {}, font {}", info.freetype_version, info.font));
  } catch (const FigureError& error) {
    console.warn(fmt::format("no figures can be drawn here: {}", wording::words(error)));
    return ExitStatus::figure_failed;
  }
  return ExitStatus::done;
}

}  // namespace

ExitStatus run_command_line(int argc, char** argv) {
  CLI::App app{overview, "tribolog"};
  keep_lines_as_written(*app.get_formatter());
  app.footer(exit_statuses);
  app.require_subcommand(0, 1);
  bool quiet = false;
  bool version = false;
  bool verbose = false;
  app.add_flag("-q,--quiet", quiet, "print warnings and errors only");
  app.add_flag("--version", version,
               "print the versions of the program and of the libraries it uses");
  app.add_flag("--verbose", verbose, "with --version: start the graphics stack and name it too");
  app.fallthrough();

  InspectOptions inspect;
  const CLI::App& inspect_command = add_inspect(app, inspect);
  InitOptions init;
  const CLI::App& init_command = add_init(app, init);
  SimulateOptions simulate;
  const CLI::App& simulate_command = add_simulate(app, simulate);
  IdentifyArguments identify;
  const CLI::App& identify_command = add_identify(app, identify);
  FiguresOptions figures;
  const CLI::App& figures_command = add_figures(app, figures);
  ReportOptions report;
  const CLI::App& report_command = add_report(app, report);
  ShowOptions show;
  const CLI::App& show_command = add_show(app, show);
  ModelsOptions models;
  const CLI::App& models_command = add_models(app, models);
  PaperOptions paper;
  const CLI::App& paper_command = add_paper(app, paper);
  PlanCommandOptions plan;
  const CLI::App& plan_command = add_plan(app, plan);
  StudyCommandOptions study;
  const CLI::App& study_command = add_study(app, study);
  const auto chosen_of_archive = add_archive(app);
  const auto chosen_review = add_review(app);
  const auto chosen_export = add_export_of_file(app);
  refuse_empty_location({argv, argv + argc});

  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp& call) {
    std::ostringstream help;
    app.exit(call, help, help);
    print(help.str());
    return ExitStatus::done;
  } catch (const CLI::ParseError& error) {
    throw UsageError(std::string(error.what()) + "; see tribolog --help");
  }
  Console console(quiet);
  const std::vector<std::string> arguments(argv, argv + argc);
  if (version) return run_version(verbose, console);
  if (inspect_command) return run_inspect(inspect, console);
  if (init_command) return run_init(init, console);
  if (simulate_command) return run_simulate(simulate, console);
  if (identify_command) return run_identify(identify, arguments, console);
  if (figures_command) return run_figures(figures, console);
  if (report_command) return run_report(report, arguments, console);
  if (show_command) return run_show(show, console);
  if (models_command) return run_models(models, arguments, console);
  if (paper_command) return run_paper(paper, arguments, console);
  if (plan_command) return run_plan(plan, arguments, console);
  if (const Run run = chosen_of_archive()) return run({arguments, console});
  if (const Run run = chosen_review()) return run({arguments, console});
  if (const Run run = chosen_export()) return run({arguments, console});
  if (study_command) return run_study_command(study, arguments, console);
  print(app.help());
  return ExitStatus::usage;
}

}  // namespace tribolog::cli
