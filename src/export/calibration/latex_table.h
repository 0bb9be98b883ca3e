#pragma once
// The results as a LaTeX table to \input.

#include <string>

#include "export/calibration/archived_joint.h"

namespace tribolog::archive {

/// Comments, then one `tabular` that needs no package: quantity, value, interval, unit, side and
/// verdict. Rounded by the intervals. Letters that pdfLaTeX cannot set become [U+XXXX].
std::string latex_table(const ArchivedJoint& joint);

}  // namespace tribolog::archive
