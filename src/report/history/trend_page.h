#pragma once
// Joints over time as one HTML file that needs nothing else.

#include <string>
#include <vector>

#include "archive/history/joint_trend.h"
#include "language/language.h"
#include "provenance.h"

#include "figures/report_figure.h"
#include "render/renderer.h"

namespace tribolog {

/// UTF-8 HTML without script or link to the outside, in the style of the report; a section for
/// each joint. Figures belong to joints by their ids, as trend_figures() makes them.
std::string trend_page(const std::vector<history::JointTrend>& trends, const Provenance& provenance,
                       const std::vector<ReportFigure>& figures,
                       const std::vector<render::DrawnFigure>& drawn,
                       Language language = Language::english);

}  // namespace tribolog
