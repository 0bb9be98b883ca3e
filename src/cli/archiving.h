#pragma once
// `--archive`: the numbers first, the report once it is on the disk.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "archive/store/calibration_archive.h"
#include "calibration/archived_calibration.h"
#include "cli/console.h"
#include "tribolog/report.h"

namespace tribolog::cli {

/// Adds manifest and recordings, as far as they are in the directory.
/// @throw InputError: one is not there, or not the one that the calibration was made from.
void add_inputs(const std::string& directory, calibration::NewCalibration& calibration);

/// "archived: 0123456789 (cal.json)", or that it is there already.
void tell_added(const archive::store::Added& added, const std::string& what, Console& console);

/// What makes calibrations hard to find again, or to tell from another robot's, counted over those
/// that are archived at a time.
class DoubtfulIdentities {
 public:
  /// @param now_utc "2026-01-31T12:00:00Z"
  void add(const calibration::Facts& facts, const std::string& now_utc);
  void tell(Console& console) const;

 private:
  std::size_t all_{0};
  std::size_t unnamed_{0};         ///< Robots without a name,
  std::size_t without_serial_{0};  ///< or with one, but without a serial number.
  std::size_t ahead_{0};           ///< Measured in the future.
};

// `--archive` of identify and report: the numbers first, the report once it is on the disk.

/// What the command line says about the archive.
struct ArchivingOptions {
  std::optional<std::string> location;  ///< Absent: nothing is archived. Empty: the user's own.
  double wait_s{5};                     ///< For another process that writes to it.
  bool inputs{false};                   ///< Manifest and recordings too.
  bool again{false};                    ///< Beside one of the same inputs.

  /// A file that no output may replace, whether it exists or not; empty: there is none.
  [[nodiscard]] std::string file() const;
};

/// A calibration's JSON, and the file that gets it.
struct NumbersToKeep {
  std::string calibration;
  std::string file;
};

/// Opens the archive before anything is computed, so that one that cannot be written is refused
/// early; one that is not there yet is made with its first calibration, and only looked for before.
class Archiving {
 public:
  /// @throw as archive::open_archive() and check_can_be_made(); UsageError: inputs or again without
  /// an archive.
  explicit Archiving(const ArchivingOptions& options);

  /// All of them or, where one cannot be archived, none. @param manifest the dataset's.
  /// @return their ids; empty where nothing is archived.
  /// @throw as archive::open_archive(); ArchiveError, OutputError: not archived.
  std::vector<std::string> keep_numbers(const std::vector<NumbersToKeep>& numbers,
                                        const std::string& manifest, Console& console);
  /// The same of one joint. @return empty where nothing is archived.
  std::string keep_numbers(const NumbersToKeep& numbers, const std::string& manifest,
                           Console& console);

  /// The joint's calibration before this one; absent where nothing is archived, or there is none
  /// before. @throw ArchiveError: what is archived of it cannot be read.
  std::optional<EarlierCalibration> since_last(const std::string& id);

  /// Nothing where nothing is archived.
  void keep_report(const std::string& id, const std::string& html, Console& console);

 private:
  void open();

  ArchivingOptions options_;
  std::optional<archive::store::CalibrationArchive> archive_;
};

}  // namespace tribolog::cli
