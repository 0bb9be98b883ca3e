#include "cli/command_line.h"

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "base/standard_output.h"
#include "calibration/provenance.h"
#include "cli/archive_commands.h"
#include "cli/command_tree.h"
#include "cli/commands.h"
#include "cli/given_files.h"
#include "cli/guide_commands.h"
#include "cli/typed_arguments.h"
#include "cli/usage_refusal.h"
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

/// From version 2.6 on CLI11 would break our lines anew, and take their indents away.
template <class Formatter>
void keep_lines_as_written(Formatter& formatter) {
  if constexpr (requires { formatter.enable_footer_formatting(false); }) {
    formatter.enable_description_formatting(false);
    formatter.enable_footer_formatting(false);
  }
}

/// @throw CLI::ParseError
void parse(CLI::App& app, std::vector<std::string> arguments) {
  std::reverse(arguments.begin(), arguments.end());  // as CLI11 takes them
  app.parse(arguments);
}

/// A file that is no value of `--archive` may still be one argument too many: it is then refused
/// as the value, as which it was typed.
/// @throw CLI::ParseError
void parse_values_told_apart(CLI::App& app, const std::vector<std::string>& arguments) {
  const std::vector<std::string> told_apart = with_values_told_apart(app, arguments);
  try {
    parse(app, told_apart);
  } catch (const CLI::ExtrasError&) {
    if (told_apart == arguments) throw;
    parse(app, arguments);
  }
}

/// @return whether there is something to run; else help was asked for, and given.
/// @throw UsageError, or InputError for a file that another command reads.
bool is_parsed(CLI::App& app, const std::vector<std::string>& typed) {
  try {
    const auto first = typed.begin() + (typed.empty() ? 0 : 1);  // behind the program's name
    parse_values_told_apart(app, arguments_to_parse(app, {first, typed.end()}));
  } catch (const CLI::CallForHelp& call) {
    std::ostringstream help;
    app.exit(call, help, help);
    print(help.str());
    return false;
  } catch (const CLI::RequiredError& error) {
    if (app.remaining(true).empty()) check_given_files(chosen_command(app));
    throw refusal_of(app, error);
  } catch (const CLI::ParseError& error) {
    throw refusal_of(app, error);
  }
  check_given_files(chosen_command(app));
  return true;
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
  app.add_flag("-V,--version", version,
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
  const auto chosen_apply = add_apply(app);
  const auto chosen_manifest = add_manifest(app);
  const auto chosen_schema = add_schema(app);
  const auto chosen_help = add_help(app);
  const CLI::App& version_command =
      *app.add_subcommand("version", "the versions of the program and of the libraries it uses");
  const auto chosen_completion = add_completion(app);
  const auto chosen_manual = add_manual(app);
  take_one_value_each(app);

  const std::vector<std::string> arguments(argv, argv + argc);
  if (!is_parsed(app, arguments)) return ExitStatus::done;
  Console console(quiet);
  if (version || version_command) return run_version(verbose, console);
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
  if (const Run run = chosen_apply()) return run({arguments, console});
  for (const auto& chosen :
       {chosen_manifest, chosen_schema, chosen_help, chosen_completion, chosen_manual}) {
    if (const Run run = chosen()) return run({arguments, console});
  }
  if (study_command) return run_study_command(study, arguments, console);
  print(app.help());
  return ExitStatus::usage;
}

}  // namespace tribolog::cli
