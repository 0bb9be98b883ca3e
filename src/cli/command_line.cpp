#include "cli/command_line.h"

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "base/standard_output.h"
#include "calibration/provenance.h"
#include "cli/command_tree.h"
#include "cli/commands.h"
#include "cli/given_files.h"
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

/// All of them, in the order of help.
const std::vector<AddCommand>& commands_in_order() {
  static const std::vector<AddCommand> all{
      add_inspect,  add_init,   add_simulate, add_identify, add_figures,    add_report, add_show,
#if TRIBOLOG_EXPERIMENTS
      add_models,   add_plan,   add_study,
#endif
#if TRIBOLOG_PAPER
      add_paper,
#endif
      add_archive,  add_review,
#if TRIBOLOG_EXPORTS
      add_export,   add_apply,
#endif
      add_manifest, add_schema, add_help,     add_version,  add_completion, add_manual,
  };
  return all;
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

Run add_version(CLI::App& app) {
  app.add_subcommand("version", "the versions of the program and of the libraries it uses");
  return [&app](const Invocation& call) {
    return run_version(app.get_option("--verbose")->as<bool>(), call.console);
  };
}

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

  const AddedCommands commands = add_commands(app, commands_in_order());
  take_one_value_each(app);

  const std::vector<std::string> arguments(argv, argv + argc);
  if (!is_parsed(app, arguments)) return ExitStatus::done;
  Console console(quiet);
  if (version) return run_version(verbose, console);
  if (const auto status = run_chosen(commands, {arguments, console})) return *status;
  print(app.help());
  return ExitStatus::usage;
}

}  // namespace tribolog::cli
