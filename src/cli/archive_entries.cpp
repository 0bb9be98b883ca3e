// `tribolog archive add`, `list` and `remove`.

#include <filesystem>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "archive/store/archive_json.h"
#include "base/early_end.h"
#include "base/input_file.h"
#include "calibration/provenance.h"
#include "calibration/read_calibration.h"
#include "cli/archive_commands.h"
#include "cli/archiving.h"
#include "inspect/survey/text_table.h"

namespace tribolog::cli {
namespace {

struct AddOptions {
  std::vector<std::string> calibrations;
  std::string report;
  std::string inputs;
  bool again{false};
  bool json{false};
};

void check(const AddOptions& options) {
  const bool of_one = !options.report.empty() || !options.inputs.empty();
  if (of_one && options.calibrations.size() > 1) {
    throw UsageError(
        "--report and --inputs apply to a single calibration; add calibrations one at a time");
  }
}

}  // namespace

Run add_archive_add(CLI::App& archive) {
  const auto options = std::make_shared<AddOptions>();
  CLI::App& command = *archive.add_subcommand("add", "archive calibrations written by identify");
  command.add_option("CALIBRATION", options->calibrations, "calibration files (JSON)")->required();
  command.add_option("--report", options->report, "its report (HTML), kept unchanged");
  command.add_option("--inputs", options->inputs,
                     "directory of its manifest: also keep manifest and recordings");
  command.add_flag("--again", options->again,
                   "if the same inputs are already archived: keep this one as well");
  command.add_flag("--json", options->json, "one line of JSON for each, as soon as it is archived");
  const auto where = add_archive_options(command);
  command.footer(
      "\nWhatever is reported as archived is on disk. The same inputs archived twice are "
      "one\nentry. All files are read before the first one is archived.");
  return [where, options](const Invocation& call) {
    check(*options);
    const std::string now = calibration::make_provenance({}).created_utc;
    std::vector<calibration::NewCalibration> made;
    for (const std::string& file : options->calibrations) {
      made.push_back(calibration::entry_of_calibration(read_file(file), file));
    }
    if (!options->inputs.empty()) add_inputs(options->inputs, made.front());
    const std::string report = options->report.empty() ? "" : read_file(options->report);
    archive::store::CalibrationArchive kept = where->open(archive::sql::Access::write);
    DoubtfulIdentities doubtful;
    for (std::size_t k = 0; k < made.size(); ++k) {
      const archive::store::Added added = kept.add(made[k], options->again, now);
      if (added.is_new) doubtful.add(made[k].facts, now);
      if (options->json) {
        if (added.is_new) note_kept("its entry " + added.id);
        print_json(archive::store::added_json(added, options->calibrations[k]));
      } else {
        tell_added(added, options->calibrations[k], call.console);
      }
      if (!report.empty() && !kept.attach_report(added.id, report, now)) {
        call.console.warn("note: " + added.id.substr(0, calibration::shown_digits) +
                          " already has a report, which is kept");
      }
    }
    doubtful.tell(call.console);
    return ExitStatus::done;
  };
}

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

Run add_archive_list(CLI::App& archive) {
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

Run add_archive_remove(CLI::App& archive) {
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
