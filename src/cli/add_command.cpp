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

Run add_add(CLI::App& archive) {
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
    for (std::size_t k = 0; k < made.size(); ++k) {
      const archive::store::Added added = kept.add(made[k], options->again, now);
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
    return ExitStatus::done;
  };
}

}  // namespace tribolog::cli
