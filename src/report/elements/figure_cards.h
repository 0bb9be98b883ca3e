#pragma once
// Figures of a page and their pictures, paired by id.

#include <vector>

#include "figures/report_figure.h"
#include "render/workers/renderer.h"
#include "report/elements/elements.h"

namespace tribolog::report::elements {

/// Pairs figures and pictures; the first three cards of a report are not lazy.
std::vector<FigureCard> figure_cards(const std::vector<figures::ReportFigure>& figures,
                                     const std::vector<render::workers::DrawnFigure>& drawn);

}  // namespace tribolog::report::elements
