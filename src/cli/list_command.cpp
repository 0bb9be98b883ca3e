#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "archive/store/archive_json.h"
#include "cli/archive_commands.h"
#include "inspect/survey/text_table.h"

namespace tribolog::cli {
namespace {

std::string table_of(const std::vector<calibration::Entry>& entries,
                     const calibration::Decisions& decisions) {
  inspect::survey::TextTable table(0);
  table.add({"id", "robot", "serial", "joint", "measured", "verdict", "decision"});
  for (const calibration::Entry& e : entries) {
    const calibration::Facts& f = e.facts;
    const auto decision = decisions.find(e.id);
    table.add({e.id.substr(0, calibration::shown_digits),
               printable(f.of.robot, inspect::survey::longest_name),
               printable(f.of.serial, inspect::survey::longest_name),
               printable(f.of.joint, inspect::survey::longest_name),
               f.measured_at + (f.time_is_stated ? "" : " (made)"),
               calibration::to_string(f.verdict),
               decision == decisions.end() ? "-" : calibration::to_string(decision->second)});
  }
  return table.text();
}

}  // namespace

Run add_list(CLI::App& archive) {
  struct Options {
    archive::store::Filter filter;
    bool json{false};
  };
  const auto options = std::make_shared<Options>();
  CLI::App& command = *archive.add_subcommand("list", "list its calibrations");
  const auto where = add_archive_options(command);
  add_filter(command, options->filter);
  command.add_flag("--json", options->json, "as JSON, to standard output");
  return [where, options](const Invocation& call) {
    archive::store::CalibrationArchive kept = where->open(archive::sql::Access::read);
    const auto entries = kept.list(options->filter);
    const calibration::Decisions decisions = kept.decisions(options->filter);
    if (options->json) {
      print_json(archive::store::entries_json(entries, decisions));
    } else {
      call.console.say(entries.empty() ? "no calibrations" : table_of(entries, decisions));
    }
    return ExitStatus::done;
  };
}

}  // namespace tribolog::cli
