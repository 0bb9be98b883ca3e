#pragma once
// The commands. Each adds itself to the program, or to `tribolog archive`: its subcommand with
// every option and its help.

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "cli/console.h"

namespace CLI {
class App;
}

namespace tribolog::cli {

/// How the program was called.
struct Invocation {
  const std::vector<std::string>& arguments;  ///< The whole command line, for the provenance.
  Console& console;
};

/// What a command does once the command line is read.
using Run = std::function<ExitStatus(const Invocation&)>;

/// Adds a command behind those that are there. @param to lives until the command has run.
using AddCommand = Run (*)(CLI::App& to);

/// Commands beside each other, each with what it does.
using AddedCommands = std::vector<std::pair<const CLI::App*, Run>>;

AddedCommands add_commands(CLI::App& to, const std::vector<AddCommand>& commands);

/// Runs the one that the command line chose.
/// @return empty: it chose none of them.
std::optional<ExitStatus> run_chosen(const AddedCommands& commands, const Invocation& call);

Run add_inspect(CLI::App& app);
Run add_init(CLI::App& app);
Run add_simulate(CLI::App& app);
Run add_identify(CLI::App& app);
Run add_figures(CLI::App& app);
Run add_report(CLI::App& app);
Run add_show(CLI::App& app);
Run add_models(CLI::App& app);
Run add_paper(CLI::App& app);
Run add_plan(CLI::App& app);
Run add_study(CLI::App& app);
Run add_archive(CLI::App& app);
Run add_review(CLI::App& app);
Run add_export(CLI::App& app);
Run add_apply(CLI::App& app);
Run add_manifest(CLI::App& app);
Run add_schema(CLI::App& app);
Run add_help(CLI::App& app);
Run add_version(CLI::App& app);
// Two that help does not list, and that packages are made with.
Run add_completion(CLI::App& app);
Run add_manual(CLI::App& app);

Run add_archive_add(CLI::App& archive);
Run add_archive_list(CLI::App& archive);
Run add_archive_show(CLI::App& archive);
Run add_archive_report(CLI::App& archive);
Run add_archive_diff(CLI::App& archive);
Run add_archive_trend(CLI::App& archive);
Run add_archive_verify(CLI::App& archive);
Run add_archive_backup(CLI::App& archive);
Run add_archive_remove(CLI::App& archive);
Run add_archive_export(CLI::App& archive);
Run add_archive_fleet(CLI::App& archive);

}  // namespace tribolog::cli
