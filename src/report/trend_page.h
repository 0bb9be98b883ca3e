#pragma once
// Joints over time as one HTML file that needs nothing else.

#include <string>
#include <vector>

#include "calibration/provenance.h"
#include "figures/report_figure.h"
#include "history/joint_trend.h"
#include "render/workers/renderer.h"
#include "wording/language.h"

namespace tribolog {

/// UTF-8 HTML without script or link to the outside, in the style of the report; a section for
/// each joint. Figures belong to joints by their ids, as trend_figures() makes them.
std::string trend_page(const std::vector<history::JointTrend>& trends, const Provenance& provenance,
                       const std::vector<ReportFigure>& figures,
                       const std::vector<render::DrawnFigure>& drawn,
                       Language language = Language::english);

}  // namespace tribolog
