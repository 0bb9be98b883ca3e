#pragma once
// A calibration on the console, whether it comes from an archive or from a file.

#include <string>
#include <vector>

#include "calibration/archived_calibration.h"

namespace tribolog::cli {

/// One line for each fact that is stated. @param id empty: it has none. @param revision 1: the only
/// one.
std::string facts_text(const calibration::Facts& facts, const std::string& id, int revision);

/// Value, interval, unit and verdict of each: SI, motor side.
std::string quantities_text(const std::vector<calibration::Quantity>& quantities);

}  // namespace tribolog::cli
