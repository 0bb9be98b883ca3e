#pragma once
// What the commands of `tribolog archive` have in common.

#include <memory>
#include <string>
#include <vector>

#include "archive/store/archive_location.h"
#include "archive/store/calibration_archive.h"
#include "base/error.h"
#include "cli/commands.h"
#include "cli/console.h"

namespace CLI {
class App;
}

namespace tribolog::cli {

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

/// JSON to standard output, also with --quiet: it was asked for.
void print_json(const std::string& json);

}  // namespace tribolog::cli
