#pragma once
// Figures as files of one or more formats.

#include <vector>

#include "figures/report_figure.h"
#include "render/workers/renderer.h"
#include "tribolog/figures.h"
#include "tribolog/values.h"

namespace tribolog::api {

/// The same figures sized for the columns of a journal. One that cannot be laid out stays as it is:
/// drawing it says why.
/// @throw tribolog::FigureError without the font.
std::vector<figures::ReportFigure> for_publication(std::vector<figures::ReportFigure> figures);

/// Only PNG and the solid parts of scenes need the graphics stack; what does not need it is written
/// without it.
/// @param figures as they are to be read: nothing is translated here
/// @param renderer may be null where it is not needed
Figures figure_files(const std::vector<figures::ReportFigure>& figures,
                     const std::vector<FigureFormat>& formats,
                     render::workers::FigureRenderer* renderer, const Progress& progress);

}  // namespace tribolog::api
