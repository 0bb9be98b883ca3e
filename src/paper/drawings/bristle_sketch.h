#pragma once
// Figure 3: two surfaces in contact through elastic bristles, the picture behind LuGre.

#include <vector>

#include "figures/report_figure.h"
#include "render/figure/diagram.h"

namespace tribolog::paper::drawings {

/// An elastic bristle, clamped at `root` and straight down (or up, if length is negative) when at
/// rest, whose tip is pushed sideways by `deflection`: the bending line of a cantilever.
std::vector<render::figure::DiagramPoint> bent_bristle(render::figure::DiagramPoint root,
                                                       double length, double deflection);

/// Corners of an upright rectangle.
std::vector<render::figure::DiagramPoint> upright_rectangle(double left, double top, double right,
                                                            double bottom);

/// Of the elastic bristles: five side by side, then the mean one, enlarged.
inline constexpr render::figure::Colour bristle_colour = render::figure::palette::blue;
inline constexpr double enlargement_of_mean_bristle = 2;

figures::ReportFigure bristle_sketch_figure();

}  // namespace tribolog::paper::drawings
