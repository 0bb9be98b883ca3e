#pragma once
// The figures of one calibration, in the paper's order (figures 11 and 13 to 22), and behind
// them those that the paper has not: the models of the curve, each direction by itself, break-away
// ramps.
//
// Nothing is estimated here: every number is the calibration's or the recording's; it is selected,
// scaled and offset for display. A figure whose stage found nothing is left out: a log that holds a
// sweep alone gives 11 and 13, and 18 to 21 from its paired directions.

#include <vector>

#include "calibration/calibration.h"
#include "figures/report_figure.h"
#include "joint/dataset.h"

namespace tribolog::figures {

/// @param dataset the one that the calibration was made from; its recordings supply the samples.
/// Never throws for what the numbers are: samples that are not finite leave gaps, an empty or
/// one-sample recording gives a figure without that curve, or no figure.
std::vector<ReportFigure> figure_set(const joint::Dataset& dataset,
                                     const calibration::Calibration& calibration);

/// As a report shows them: without a title, which its heading has; without those that another of
/// them combines (friction curves, reference and errors in one; the selected curve with all laws);
/// in a resolution for screens and office printers, lower where it folds them; letters are as
/// large.
std::vector<ReportFigure> for_a_report(std::vector<ReportFigure> figures);

}  // namespace tribolog::figures
