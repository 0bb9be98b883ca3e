#include "cli/archive_commands.h"

#include <utility>

#include <CLI/CLI.hpp>

#include "base/atomic_file.h"
#include "base/shown_text.h"
#include "base/standard_output.h"
#include "cli/shared_options.h"

namespace tribolog::cli {

archive::store::CalibrationArchive ArchiveOptions::open(archive::sql::Access access) const {
  return archive::store::open_archive(location, access, static_cast<int>(1e3 * wait_s));
}

void ArchiveOptions::protect_from(const std::string& output) const {
  if (output.empty()) return;
  std::vector<std::string> files;
  if (!archive::store::is_server(location)) {
    files.push_back(location.empty() ? archive::store::default_location() : location);
  }
  check_output_can_be_written(output, files);
}

void make_way(Console& console, const std::string& output, bool prints_json) {
  if (prints_json && is_standard_output(output)) {
    throw UsageError("-o and --json cannot both go to standard output; give a file for -o");
  }
  console.make_way_for(output);
}

std::shared_ptr<ArchiveOptions> add_archive_options(CLI::App& command) {
  constexpr double longest_s = 3600;
  auto options = std::make_shared<ArchiveOptions>();
  command
      .add_option("--archive", options->location,
                  "the archive: a file, or postgresql://...; default: "
                  "tribolog/archive.tribolog in the user's data directory")
      ->check([](const std::string& location) {  // a variable of a script that is not set
        return location.empty() ? std::string("is empty; state a file, or leave --archive out")
                                : std::string();
      });
  command
      .add_option("--wait", options->wait_s, "seconds to wait while another process writes to it")
      ->check(number_between(0, longest_s))
      ->capture_default_str();
  return options;
}

void add_filter(CLI::App& command, archive::store::Filter& filter) {
  command.add_option("--robot", filter.robot, "only this robot");
  command.add_option("--serial", filter.serial, "only this serial number");
  command.add_option("--joint", filter.joint, "only this joint");
}

std::function<Run()> add_archive(CLI::App& app) {
  CLI::App* const archive = app.add_subcommand("archive", "keep, compare and monitor calibrations");
  archive->require_subcommand(1);
  archive->fallthrough();
  std::vector<std::pair<CLI::App*, Run>> commands;
  for (Run (*add)(CLI::App&) : {add_add, add_list, add_show, add_report, add_diff, add_trend,
                                add_fleet, add_export, add_verify, add_backup, add_remove}) {
    Run run = add(*archive);
    commands.emplace_back(archive->get_subcommands({}).back(), std::move(run));
  }
  return [archive, commands]() -> Run {
    if (!*archive) return {};
    for (const auto& [command, run] : commands) {
      if (*command) return run;
    }
    return {};
  };
}

void print_json(const std::string& json) { print(json_without_hidden(json)); }

}  // namespace tribolog::cli
