#pragma once
// Panels that show nothing, or not what it is.

#include "render/figure/draw_list.h"
#include "render/legibility/finding.h"

namespace tribolog::render::legibility {

/// Panels of the figure without a curve, marker, interval, band or named point in the list.
Findings empty_panels(const figure::DrawList& list, const figure::Figure& figure);

/// Axes without a title, or whose title ends without a unit in brackets: "T [N·m]". Dates need
/// none, and neither do titles that `without_unit` lists (counts and names).
Findings axes_without_unit(const figure::Figure& figure,
                           const std::vector<std::string>& without_unit);

/// Curves and markers that reach out of their axes box.
Findings data_outside_axes(const figure::DrawList& list);

}  // namespace tribolog::render::legibility
