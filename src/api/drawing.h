#pragma once
// Drawing a calibration's figures, and naming what drew them.

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "calibration/provenance.h"
#include "figures/report_figure.h"
#include "render/workers/renderer.h"
#include "tribolog/figures.h"

namespace tribolog::api {

/// Called after each figure with (done, all).
using DrawingProgress = std::function<void(std::size_t done, std::size_t all)>;

/// Pictures in the order of the figures. A graphics stack that cannot start at all leaves every
/// picture with its error.
std::vector<render::workers::DrawnFigure> draw(render::workers::FigureRenderer& renderer,
                                               const std::vector<figures::ReportFigure>& figures,
                                               const DrawingProgress& progress);

/// The graphics stack, for the provenance; absent if nothing was drawn.
std::optional<calibration::DrawingSoftware> software_that_drew(
    const std::vector<render::workers::DrawnFigure>& drawn);

std::vector<FigureOutcome> outcomes_of(const std::vector<render::workers::DrawnFigure>& drawn);

}  // namespace tribolog::api
