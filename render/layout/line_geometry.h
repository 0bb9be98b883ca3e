#pragma once
// Where lines run.

#include <vector>

#include "render/figure/pixel_geometry.h"

namespace tribolog::render {

/// Whether a point is within `reach` of a line.
bool lies_on(const std::vector<PixelPoint>& line, PixelPoint p, double reach);

/// Whether some of a line is inside a box; touching its border is not.
bool enters(const std::vector<PixelPoint>& line, const PixelBox& box);

}  // namespace tribolog::render
