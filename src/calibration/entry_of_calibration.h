#pragma once
// What an archive keeps of a calibration, from the file that `tribolog identify` writes.

#include <string>

#include "calibration/archived_calibration.h"

namespace tribolog::calibration {

/// Facts, quantities, inputs and the file itself. The only way into an archive, so that `identify`,
/// `report` and `archive add` archive the same.
/// @param json the whole file. @param file its name, for messages.
/// @throw InputError: no JSON, no calibration, or one that says something impossible.
NewCalibration entry_of_calibration(const std::string& json, const std::string& file);

/// "2026-01-31", "2026-01-31 14:05", "2026-01-31T14:05:09+01:00" -> "2026-01-31T13:05:09Z". Without
/// an offset it is taken for UTC. @return empty for anything else.
std::string utc_of_iso_text(const std::string& text);

/// Since 1970, of a time that utc_of_iso_text() gave; 0 for anything else.
double seconds_of_utc(const std::string& utc);

}  // namespace tribolog::calibration
