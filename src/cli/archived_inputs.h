#pragma once
// What `archive add` and `report --archive` have in common.

#include <string>

#include "archive/store/calibration_archive.h"
#include "calibration/archived_calibration.h"
#include "cli/console.h"

namespace tribolog::cli {

/// Adds manifest and recordings, as far as they are in the directory.
/// @throw InputError: one is not there, or not the one that the calibration was made from.
void add_inputs(const std::string& directory, archive::NewCalibration& calibration);

/// "archived: 0123456789 (cal.json)", or that it is there already.
void tell_added(const archive::Added& added, const std::string& what, Console& console);

}  // namespace tribolog::cli
