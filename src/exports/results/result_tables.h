#pragma once
// The results as tables: CSV and LaTeX.

#include <string>

#include "exports/results/archived_joint.h"

namespace tribolog::exports::results {

/// Lines behind `#`, then quantity, value, low, high, unit, side, verdict, conversion; a row for
/// each quantity and side. Numbers read back to the same doubles. A text that a spreadsheet would
/// take for a formula (from = + - @) gets an apostrophe in front.
std::string csv_table(const ArchivedJoint& joint);

// The results as a LaTeX table to \input.

/// Comments, then one `tabular` that needs no package: quantity, value, interval, unit, side and
/// verdict. Rounded by the intervals. Letters that pdfLaTeX cannot set become [U+XXXX].
std::string latex_table(const ArchivedJoint& joint);

}  // namespace tribolog::exports::results
