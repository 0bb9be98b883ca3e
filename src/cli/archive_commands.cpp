#include "cli/archive_commands.h"

#include <utility>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "archive/store/archive_json.h"
#include "base/atomic_file.h"
#include "base/shown_text.h"
#include "base/standard_output.h"
#include "cli/shared_options.h"
#include "inspect/survey/text_table.h"

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

Run add_archive(CLI::App& app) {
  CLI::App* const archive = app.add_subcommand("archive", "keep, compare and monitor calibrations");
  archive->require_subcommand(1);
  archive->fallthrough();
  const AddedCommands commands = add_commands(
      *archive, {add_archive_add, add_archive_list, add_archive_show, add_archive_report,
                 add_archive_diff, add_archive_trend, add_archive_fleet,
#if TRIBOLOG_EXPORTS
                 add_archive_export,
#endif
                 add_archive_verify, add_archive_backup, add_archive_remove});
  return [commands](const Invocation& call) {
    return run_chosen(commands, call).value_or(ExitStatus::usage);
  };
}

void print_json(const std::string& json) { print(json_without_hidden(json)); }

// `tribolog archive verify` and `backup`.

Run add_archive_verify(CLI::App& archive) {
  struct Options {
    std::string head;
    bool json{false};
  };
  const auto options = std::make_shared<Options>();
  CLI::App& command =
      *archive.add_subcommand("verify", "prove that nothing in it was lost or altered");
  command.add_option("--head", options->head,
                     "a head reported by an earlier verify: nothing before it may be lost");
  const auto where = add_archive_options(command);
  command.add_flag("--json", options->json, "as JSON, to standard output");
  command.footer(
      "\nEach calibration has a digest of its contents, each addition and removal is a link in "
      "a\nchain. The last link, the head, identifies the state of the archive: written down, it "
      "proves\nlater that nothing up to it was lost. Status 6 if something is wrong.");
  return [where, options](const Invocation& call) {
    const auto outcome = where->open(archive::sql::Access::read)
                             .verify(options->head, [&](std::size_t done, std::size_t all) {
                               call.console.progress("verifying", done, all);
                             });
    call.console.finish();
    if (options->json) {
      print_json(archive::store::verification_json(outcome));
    } else if (outcome.faults.empty()) {
      call.console.say(fmt::format("whole: {}, {}, {} of the chain\nhead: {}",
                                   inspect::survey::plural(outcome.entries, "calibration"),
                                   inspect::survey::plural(outcome.documents, "document"),
                                   inspect::survey::plural(outcome.events, "link"), outcome.head));
    }
    for (const std::string& fault : outcome.faults) {
      call.console.warn("damaged: " + printable(fault, 400));
    }
    return outcome.faults.empty() ? ExitStatus::done : ExitStatus::archive_failed;
  };
}

Run add_archive_backup(CLI::App& archive) {
  const auto output = std::make_shared<std::string>();
  CLI::App& command = *archive.add_subcommand("backup", "write a copy to another file");
  command.add_option("-o,--output", *output, "file to write; must not exist yet")->required();
  const auto where = add_archive_options(command);
  command.footer("\nOthers may keep archiving meanwhile: the copy is a consistent snapshot.");
  return [where, output](const Invocation& call) {
    if (*output == "-") {
      throw UsageError("archive backup: a backup is a database and needs a file");
    }
    where->protect_from(*output);
    where->open(archive::sql::Access::read).backup(*output);
    call.console.say("backup: " + printable(*output, longest_path));
    return ExitStatus::done;
  };
}

}  // namespace tribolog::cli
