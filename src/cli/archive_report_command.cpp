#include <CLI/CLI.hpp>

#include "base/atomic_file.h"
#include "cli/archive_commands.h"
#include "cli/signed_report.h"

namespace tribolog::cli {

Run add_report(CLI::App& archive) {
  struct Options {
    std::string id;
    std::string output;
    std::string calibration;
    bool original{false};
  };
  const auto options = std::make_shared<Options>();
  CLI::App& command =
      *archive.add_subcommand("report", "the report of one calibration, as it was made");
  command.add_option("ID", options->id, "the first digits of its id")->required();
  command.add_option("-o,--output", options->output, "report (HTML) to write");
  command.add_option("--calibration", options->calibration, "calibration (JSON) to write");
  command.add_flag("--original", options->original,
                   "byte for byte, without the decisions of reviewers");
  const auto where = add_archive_options(command);
  return [where, options](const Invocation& call) {
    if (options->output.empty() && options->calibration.empty()) {
      throw UsageError("archive report: -o REPORT or --calibration FILE is needed");
    }
    where->protect_from(options->output);
    where->protect_from(options->calibration);
    check_outputs_differ({options->output, options->calibration});
    for (const std::string& output : {options->output, options->calibration}) {
      call.console.make_way_for(output);
    }
    archive::store::CalibrationArchive kept = where->open(archive::sql::Access::read);
    const calibration::Entry entry = kept.find(options->id);
    AtomicFiles files;
    if (!options->output.empty()) {
      files.add(options->output,
                options->original ? original_report(kept, entry) : signed_report(kept, entry));
    }
    if (!options->calibration.empty()) {
      const auto bytes = kept.document(entry, calibration::DocumentKind::calibration);
      if (!bytes)
        throw ArchiveError(printable(kept.name(), longest_path) + ": its calibration is missing");
      files.add(options->calibration, *bytes);
    }
    files.commit();
    const auto tell = [&](const char* what, const std::string& path) {
      if (!path.empty()) call.console.say(what + (": " + printable(path, longest_path)));
    };
    tell("report", options->output);
    tell("calibration", options->calibration);
    return ExitStatus::done;
  };
}

}  // namespace tribolog::cli
