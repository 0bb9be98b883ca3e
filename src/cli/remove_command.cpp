#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "archive/store/archive_json.h"
#include "calibration/provenance.h"
#include "cli/archive_commands.h"

namespace tribolog::cli {

Run add_remove(CLI::App& archive) {
  struct Options {
    std::vector<std::string> ids;
    bool is_sure{false};
    bool json{false};
  };
  const auto options = std::make_shared<Options>();
  CLI::App& command = *archive.add_subcommand("remove", "remove calibrations permanently");
  command.add_option("ID", options->ids, "the first digits of their ids")->required();
  command.add_flag("--yes", options->is_sure, "without it, only show what would be removed");
  command.add_flag("--json", options->json, "what was removed, as JSON to standard output");
  const auto where = add_archive_options(command);
  command.footer("\nThe chain records that it was removed, and when.");
  return [where, options](const Invocation& call) {
    const std::string now = calibration::make_provenance({}).created_utc;
    archive::store::CalibrationArchive kept =
        where->open(options->is_sure ? archive::sql::Access::write : archive::sql::Access::read);
    std::vector<calibration::Entry> entries;
    for (const std::string& id : options->ids) entries.push_back(kept.find(id));
    for (const calibration::Entry& entry : entries) {
      const calibration::JointName& of = entry.facts.of;
      const std::string what =
          fmt::format("{} ({}, joint {}, {})", entry.id.substr(0, calibration::shown_digits),
                      printable(of.robot), printable(of.joint), entry.facts.measured_at);
      if (options->is_sure) kept.remove(entry, now);
      if (options->json && options->is_sure) continue;
      call.console.say((options->is_sure ? "removed: " : "would be removed: ") + what);
    }
    if (!options->is_sure) {
      throw UsageError("archive remove: nothing was removed; --yes removes permanently");
    }
    if (options->json) print_json(archive::store::removed_json(entries));
    return ExitStatus::done;
  };
}

}  // namespace tribolog::cli
