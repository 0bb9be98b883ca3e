#pragma once
// Figure 3: two surfaces in contact through elastic bristles, the picture behind LuGre.

#include "figures/report_figure.h"

namespace tribolog::paper {

/// Of the elastic bristles: five side by side, then the mean one, enlarged.
inline constexpr render::Colour bristle_colour = render::palette::blue;
inline constexpr double enlargement_of_mean_bristle = 2;

ReportFigure bristle_sketch_figure();

}  // namespace tribolog::paper
