#pragma once
// Two calibrations side by side, in words for the console and as one HTML file.

#include <string>
#include <vector>

#include "calibration/provenance.h"
#include "calibration/read_calibration.h"
#include "figures/report_figure.h"
#include "history/comparison.h"
#include "render/workers/renderer.h"
#include "report/elements/elements.h"
#include "wording/language.h"

namespace tribolog::report::timeline {

/// "Coulomb torque rose by 0.12 N·m (14 %), beyond chance; 3 of 9 comparable quantities changed; 2
/// are not comparable." The one named is Comparison::largest_change().
std::string comparison_sentence(const history::Comparison& comparison);

/// A row for each quantity: first, second, change, in percent, word.
elements::Table compared_quantities_table(const history::Comparison& comparison);

/// Temperature, payload and so on of both.
elements::Table compared_conditions_table(const history::Comparison& comparison);

/// "Coulomb torque is not comparable: ...", cautions, remarks; each a sentence. What is said of
/// several quantities stands once.
std::vector<std::string> comparison_notes(const history::Comparison& comparison);

// Two calibrations side by side as one HTML file that needs nothing else.

/// UTF-8 HTML without link to the outside, in the style of the report; with the loop viewer, and
/// its script, where both calibrations have loops.
/// @param first curves of the first calibration, as archived; `second` likewise. @param
/// curves_missing why there are no figures, or not all; empty: all are there.
std::string comparison_page(const history::Comparison& comparison,
                            const calibration::RecordedCurves& first,
                            const calibration::RecordedCurves& second,
                            const calibration::Provenance& provenance,
                            const std::string& curves_missing,
                            const std::vector<figures::ReportFigure>& figures,
                            const std::vector<render::workers::DrawnFigure>& drawn,
                            wording::Language language = wording::Language{});

}  // namespace tribolog::report::timeline
