// Commands that say what the program can do: `tribolog help`, `manifest`, `schema`, and two that
// help does not list and that packages are made with, `completion SHELL` and `manual DIRECTORY`.

#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "base/atomic_file.h"
#include "base/closest_match.h"
#include "base/error.h"
#include "base/standard_output.h"
#include "calibration/calibration_json.h"
#include "calibration/provenance.h"
#include "cli/command_tree.h"
#include "cli/commands.h"
#include "cli/completion.h"
#include "cli/manifest_keys.h"
#include "cli/manual_pages.h"
#include "cli/shared_options.h"
#include "cli/usage_refusal.h"

namespace tribolog::cli {
namespace {

constexpr const char* hidden = "";  // no group of help's

}  // namespace

Run add_help(CLI::App& app) {
  const auto path = std::make_shared<std::vector<std::string>>();
  CLI::App& command = *app.add_subcommand("help", "what a command does, and its options");
  const auto markdown = std::make_shared<bool>(false);
  command.add_option("COMMAND", *path, "the command; none: all of them in a line each");
  command.add_flag("--markdown", *markdown, "of the command and all below it, as Markdown");
  return [&app, path, markdown](const Invocation&) {
    const CLI::App& of = command_named(app, *path);
    if (*markdown) {
      print(command_reference(of));
      return ExitStatus::done;
    }
    print(of.get_formatter()->make_help(&of, typed(of), CLI::AppFormatMode::Normal));
    return ExitStatus::done;
  };
}

Run add_schema(CLI::App& app) {
  app.add_subcommand("schema", "the JSON schema of calibrations");
  return [](const Invocation&) {
    print(calibration::calibration_schema());
    return ExitStatus::done;
  };
}

Run add_manifest(CLI::App& app) {
  const auto table = std::make_shared<std::string>();
  CLI::App& command = *app.add_subcommand("manifest", "every key of a dataset manifest (Markdown)");
  command.add_option("TABLE", *table, "one table, such as 'effects' or 'columns'; none: all");
  return [table](const Invocation&) {
    const std::string reference = manifest_reference(*table);
    if (reference.empty()) {
      std::vector<std::string> names;
      for (const ManifestTable& one : manifest_tables()) {
        if (!one.names.front().empty()) names.push_back(one.names.front());
      }
      const std::string meant = did_you_mean(*table, names);
      throw UsageError(fmt::format("{} is no table of a manifest; {}", in_quotes(*table),
                                   meant.empty() ? "its tables: " + list_of_names(names) : meant));
    }
    print(reference);
    return ExitStatus::done;
  };
}

Run add_completion(CLI::App& app) {
  const auto shell = std::make_shared<std::string>();
  CLI::App& command = *app.add_subcommand("completion", "a shell's completion of the program");
  command.group(hidden);
  command.add_option("SHELL", *shell, "bash, zsh or fish")
      ->required()
      ->check(one_of(shells_with_completion()));
  return [&app, shell](const Invocation&) {
    print(completion_script(app, *shell));
    return ExitStatus::done;
  };
}

Run add_manual(CLI::App& app) {
  const auto directory = std::make_shared<std::string>();
  CLI::App& command = *app.add_subcommand("manual", "the manual pages, for man");
  command.group(hidden);
  command.add_option("DIRECTORY", *directory, "directory to write to")->required();
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
}

}  // namespace tribolog::cli
