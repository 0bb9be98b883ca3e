#pragma once
// The results as CSV for a spreadsheet or a script.

#include <string>

#include "export/calibration/archived_joint.h"

namespace tribolog::archive {

/// Lines behind `#`, then quantity, value, low, high, unit, side, verdict, conversion; a row for
/// each quantity and side. Numbers read back to the same doubles. A text that a spreadsheet would
/// take for a formula (from = + - @) gets an apostrophe in front.
std::string csv_table(const ArchivedJoint& joint);

}  // namespace tribolog::archive
