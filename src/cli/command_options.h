#pragma once
// What each command is told on the command line: its subcommand with every option and its help.

#include <CLI/CLI.hpp>

#include "cli/commands.h"

namespace tribolog {

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

}  // namespace tribolog
