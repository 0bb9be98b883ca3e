#pragma once
// What of two calibrations' conditions is the same.

#include "calibration/archived_calibration.h"

namespace tribolog::history {

bool has_same_gear(const archive::Facts& a, const archive::Facts& b);
/// Name, mass and distance; one that is stated and one that is not are two.
bool has_same_payload(const archive::Facts& a, const archive::Facts& b);

}  // namespace tribolog::history
