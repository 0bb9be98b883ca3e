#pragma once
// Drawing a calibration's figures with progress, and naming those that failed.

#include <cstddef>
#include <optional>
#include <vector>

#include "calibration/provenance.h"
#include "cli/console.h"
#include "figures/report_figure.h"
#include "render/workers/renderer.h"

namespace tribolog::cli {

/// Pictures in the order of the figures. A graphics stack that
/// cannot start at all leaves every picture with its error.
std::vector<render::workers::DrawnFigure> draw(render::workers::FigureRenderer& renderer,
                                               const std::vector<figures::ReportFigure>& figures,
                                               Console& console);

/// The graphics stack, for the provenance; absent if nothing was drawn.
std::optional<calibration::DrawingSoftware> software_that_drew(
    const std::vector<render::workers::DrawnFigure>& drawn);

/// Warns of each figure that failed; returns how many did.
std::size_t tell_failures(const std::vector<render::workers::DrawnFigure>& drawn, Console& console);

}  // namespace tribolog::cli
