#include "cli/commands.h"
#include "cli/shared_options.h"

namespace tribolog::cli {

CLI::App& add_show(CLI::App& app, ShowOptions& show) {
  CLI::App& command =
      *app.add_subcommand("show", "the numbers of a report, read from the report itself");
  command.add_option("FILE", show.file, "report (HTML) or calibration (JSON)")->required();
  command.add_flag("--json", show.json, "all of them as JSON, to standard output");
  command.footer(
      "\nEvery tribolog page embeds its numbers as JSON; --json returns them as they\nare. Values "
      "are SI, torques at the motor.");
  return command;
}

CLI::App& add_models(CLI::App& app, ModelsOptions& models) {
  CLI::App& command =
      *app.add_subcommand("models", "list the friction models, or compare them in one page");
  command.add_flag("--compare", models.compare, "draw all of them side by side");
  command.add_option("-o,--output", models.output, "page (HTML) to write, with --compare");
  add_processes(command, models.processes);
  add_language(command, models.language);
  return command;
}

CLI::App& add_paper(CLI::App& app, PaperOptions& paper) {
  CLI::App& command =
      *app.add_subcommand("paper", "regenerate the paper, and check it against the printed one");
  command.add_option("-o,--output", paper.output, "page (HTML) to write")->required();
  add_processes(command, paper.processes);
  add_language(command, paper.language);
  command.footer(
      "\nSimulates the paper's joint, identifies it, draws all figures, and compares every "
      "figure,\ntable and equation with what is printed. Status 1 if a check does not hold.");
  return command;
}

}  // namespace tribolog::cli
