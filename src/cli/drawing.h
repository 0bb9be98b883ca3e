#pragma once
// Drawing a calibration's figures with progress, and naming those that failed.

#include <cstddef>
#include <vector>

#include "cli/console.h"
#include "figures/report_figure.h"
#include "render/workers/renderer.h"
#include "tribolog/figures.h"

namespace tribolog::cli {

/// Pictures in the order of the figures. A graphics stack that
/// cannot start at all leaves every picture with its error.
std::vector<render::workers::DrawnFigure> draw(render::workers::FigureRenderer& renderer,
                                               const std::vector<figures::ReportFigure>& figures,
                                               Console& console);

/// Warns of each figure that failed; returns how many did.
std::size_t tell_failures(const std::vector<FigureOutcome>& figures, Console& console);
std::size_t tell_failures(const std::vector<render::workers::DrawnFigure>& drawn, Console& console);

}  // namespace tribolog::cli
