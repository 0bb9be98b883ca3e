#include <CLI/CLI.hpp>

#include "cli/archive/archive_commands.h"
#include "cli/archive/signed_report.h"
#include "files/atomic_file.h"

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
    archive::CalibrationArchive kept = where->open(sql::Access::read);
    const archive::Entry entry = kept.find(options->id);
    const auto write = [&](const std::string& path, const char* words, const std::string& bytes) {
      write_file_atomically(path, bytes);
      call.console.say(words + (": " + printable(path, longest_path)));
    };
    if (!options->output.empty()) {
      write(options->output, "report",
            options->original ? original_report(kept, entry) : signed_report(kept, entry));
    }
    if (!options->calibration.empty()) {
      const auto bytes = kept.document(entry, archive::DocumentKind::calibration);
      if (!bytes)
        throw ArchiveError(printable(kept.name(), longest_path) + ": its calibration is missing");
      write(options->calibration, "calibration", *bytes);
    }
    return ExitStatus::done;
  };
}

}  // namespace tribolog::cli
