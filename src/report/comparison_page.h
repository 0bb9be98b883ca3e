#pragma once
// Two calibrations side by side as one HTML file that needs nothing else.

#include <string>
#include <vector>

#include "calibration/provenance.h"
#include "figures/report_figure.h"
#include "history/comparison.h"
#include "render/workers/renderer.h"
#include "wording/language.h"

namespace tribolog {

/// UTF-8 HTML without script or link to the outside, in the style of the report.
/// @param curves_missing why there are no figures, or not all; empty: all are there.
std::string comparison_page(const history::Comparison& comparison, const Provenance& provenance,
                            const std::string& curves_missing,
                            const std::vector<ReportFigure>& figures,
                            const std::vector<render::DrawnFigure>& drawn,
                            Language language = Language::english);

}  // namespace tribolog
