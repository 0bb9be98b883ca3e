#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "archive/archive_json.h"
#include "inspect/text_table.h"

#include "cli/archive/archive_commands.h"

namespace tribolog::cli {
namespace {

std::string table_of(const std::vector<archive::Entry>& entries) {
  TextTable table(0);
  table.add({"id", "robot", "serial", "joint", "measured", "verdict"});
  for (const archive::Entry& e : entries) {
    const archive::Facts& f = e.facts;
    table.add({e.id.substr(0, archive::shown_digits), printable(f.of.robot, longest_name),
               printable(f.of.serial, longest_name), printable(f.of.joint, longest_name),
               f.measured_at + (f.time_is_stated ? "" : " (made)"), to_string(f.verdict)});
  }
  return table.text();
}

}  // namespace

Run add_list(CLI::App& archive) {
  struct Options {
    archive::Filter filter;
    bool json{false};
  };
  const auto options = std::make_shared<Options>();
  CLI::App& command = *archive.add_subcommand("list", "which calibrations it holds");
  const auto where = add_archive_options(command);
  add_filter(command, options->filter);
  command.add_flag("--json", options->json, "as JSON, to standard output");
  return [where, options](const Invocation& call) {
    const auto entries = where->open(sql::Access::read).list(options->filter);
    if (options->json) {
      print_json(archive::entries_json(entries));
    } else {
      call.console.say(entries.empty() ? "no calibrations" : table_of(entries));
    }
    return ExitStatus::done;
  };
}

}  // namespace tribolog::cli
