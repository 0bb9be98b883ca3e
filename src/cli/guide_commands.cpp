#include "cli/guide_commands.h"

#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "base/atomic_file.h"
#include "base/standard_output.h"
#include "calibration/provenance.h"
#include "cli/command_tree.h"
#include "cli/completion.h"
#include "cli/manual_pages.h"
#include "cli/shared_options.h"
#include "cli/usage_refusal.h"

namespace tribolog::cli {
namespace {

constexpr const char* hidden = "";  // no group of help's

}  // namespace

std::function<Run()> add_help(CLI::App& app) {
  const auto path = std::make_shared<std::vector<std::string>>();
  CLI::App& command = *app.add_subcommand("help", "what a command does, and its options");
  command.add_option("COMMAND", *path, "the command; none: all of them in a line each");
  return [&app, &command, path]() -> Run {
    if (!command) return {};
    return [&app, path](const Invocation&) {
      const CLI::App& of = command_named(app, *path);
      print(of.get_formatter()->make_help(&of, typed(of), CLI::AppFormatMode::Normal));
      return ExitStatus::done;
    };
  };
}

std::function<Run()> add_completion(CLI::App& app) {
  const auto shell = std::make_shared<std::string>();
  CLI::App& command = *app.add_subcommand("completion", "a shell's completion of the program");
  command.group(hidden);
  command.add_option("SHELL", *shell, "bash, zsh or fish")
      ->required()
      ->check(one_of(shells_with_completion()));
  return [&app, &command, shell]() -> Run {
    if (!command) return {};
    return [&app, shell](const Invocation&) {
      print(completion_script(app, *shell));
      return ExitStatus::done;
    };
  };
}

std::function<Run()> add_manual(CLI::App& app) {
  const auto directory = std::make_shared<std::string>();
  CLI::App& command = *app.add_subcommand("manual", "the manual pages, for man");
  command.group(hidden);
  command.add_option("DIRECTORY", *directory, "directory to write to")->required();
  return [&app, &command, directory]() -> Run {
    if (!command) return {};
    return [&app, directory](const Invocation&) {
      AtomicFiles files;
      files.make_directory(*directory);
      const std::string version = calibration::make_provenance({}).tool_version;
      for (const ManualPage& page : manual_pages(app, version)) {
        files.add(*directory + "/" + page.name, page.text);
      }
      files.commit();
      return ExitStatus::done;
    };
  };
}

}  // namespace tribolog::cli
