#include <CLI/CLI.hpp>

#include "cli/archive/archive_commands.h"
#include "files/atomic_file.h"

namespace tribolog::cli {

Run add_report(CLI::App& archive) {
  struct Options {
    std::string id;
    std::string output;
    std::string calibration;
  };
  const auto options = std::make_shared<Options>();
  CLI::App& command =
      *archive.add_subcommand("report", "the report of one calibration, byte for byte");
  command.add_option("ID", options->id, "the first digits of its id")->required();
  command.add_option("-o,--output", options->output, "report (HTML) to write");
  command.add_option("--calibration", options->calibration, "calibration (JSON) to write");
  const auto where = add_archive_options(command);
  return [where, options](const Invocation& call) {
    if (options->output.empty() && options->calibration.empty()) {
      throw UsageError("archive report: -o REPORT or --calibration FILE is needed");
    }
    where->protect_from(options->output);
    where->protect_from(options->calibration);
    archive::CalibrationArchive kept = where->open(sql::Access::read);
    const archive::Entry entry = kept.find(options->id);
    const auto write = [&](archive::DocumentKind kind, const std::string& path,
                           const std::string& words) {
      if (path.empty()) return;
      const auto bytes = kept.document(entry, kind);
      if (!bytes) {
        throw UsageError(entry.id.substr(0, archive::shown_digits) + " has no " + words +
                         " in the archive; tribolog report --archive keeps one");
      }
      write_file_atomically(path, *bytes);
      call.console.say(words + ": " + printable(path, longest_path));
    };
    write(archive::DocumentKind::report, options->output, "report");
    write(archive::DocumentKind::calibration, options->calibration, "calibration");
    return ExitStatus::done;
  };
}

}  // namespace tribolog::cli
