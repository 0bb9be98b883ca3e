#pragma once
// A report out of the archive, with what reviewers decided on it.

#include <string>
#include <vector>

#include "archive/store/calibration_archive.h"

namespace tribolog::cli {

/// Its bytes as they were archived where nobody decided; else with all decisions.
/// @param further decisions that are not in the archive yet.
/// @throw UsageError: the entry has no report. ArchiveError: it is not what was archived.
std::string signed_report(archive::store::CalibrationArchive& kept, const calibration::Entry& entry,
                          const std::vector<calibration::Review>& further = {});

/// As it was archived, byte for byte. @throw as signed_report().
std::string original_report(archive::store::CalibrationArchive& kept,
                            const calibration::Entry& entry);

}  // namespace tribolog::cli
