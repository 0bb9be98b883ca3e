#pragma once
// Line styles as lengths, and lines cut into dashes.

#include <vector>

#include "render/figure/figure.h"
#include "render/figure/pixel_geometry.h"

namespace tribolog::render {

/// Ink and gap in turn, in pixels; empty for a solid line. Scaled with the width, so that every
/// style looks alike in thin and thick.
std::vector<double> dash_lengths(LineStyle style, double width);

/// The inked parts of a line. @pre an even number of positive lengths, or none (the whole line).
std::vector<std::vector<PixelPoint>> cut_into_dashes(const std::vector<PixelPoint>& line,
                                                     const std::vector<double>& lengths);

}  // namespace tribolog::render
