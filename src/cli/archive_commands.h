#pragma once
// `tribolog archive ...`: its commands, and what they have in common.

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "archive/store/archive_location.h"
#include "archive/store/calibration_archive.h"
#include "base/error.h"
#include "cli/console.h"

namespace CLI {
class App;
}

namespace tribolog::cli {

/// How the program was called.
struct Invocation {
  const std::vector<std::string>& arguments;  ///< The whole command line, for the provenance.
  Console& console;
};

/// What a command does once the command line is read.
using Run = std::function<ExitStatus(const Invocation&)>;

/// `--archive` and `--wait`, which every command has.
struct ArchiveOptions {
  std::string location;  ///< Empty: the user's own.
  double wait_s{5};

  [[nodiscard]] archive::store::CalibrationArchive open(archive::sql::Access access) const;
  /// To be called for each output before anything is written; empty: none was asked for.
  /// @throw OutputError: it cannot be written. UsageError: it is the archive itself.
  void protect_from(const std::string& output) const;
};

/// An output and `--json` both: standard output then has the JSON, and the output is a file.
/// @throw UsageError: both are standard output.
void make_way(Console& console, const std::string& output, bool prints_json);
std::shared_ptr<ArchiveOptions> add_archive_options(CLI::App& command);

/// `--robot`, `--serial`, `--joint`.
void add_filter(CLI::App& command, archive::store::Filter& filter);

/// Each adds its command to `tribolog archive`, and says what it does.
Run add_add(CLI::App& archive);
Run add_list(CLI::App& archive);
Run add_show(CLI::App& archive);
Run add_report(CLI::App& archive);
Run add_diff(CLI::App& archive);
Run add_trend(CLI::App& archive);
Run add_verify(CLI::App& archive);
Run add_backup(CLI::App& archive);
Run add_remove(CLI::App& archive);
Run add_export(CLI::App& archive);
Run add_fleet(CLI::App& archive);

/// Adds `tribolog archive` with all of them.
/// @return runs the one that the command line chose; empty where it chose another command.
std::function<Run()> add_archive(CLI::App& app);

/// Adds `tribolog review`. @return as add_archive().
std::function<Run()> add_review(CLI::App& app);

/// Adds `tribolog export`. @return as add_archive().
std::function<Run()> add_export_of_file(CLI::App& app);

/// Adds `tribolog apply`. @return as add_archive().
std::function<Run()> add_apply(CLI::App& app);

/// JSON to standard output, also with --quiet: it was asked for.
void print_json(const std::string& json);

}  // namespace tribolog::cli
