#pragma once
// What is cut off at the edge of a finished picture.

#include "render/figure/picture.h"
#include "render/legibility/finding.h"

namespace tribolog::render::legibility {

/// Ink in the outermost pixels: every figure has a white margin, so what reaches them goes on
/// beyond. At most one finding for each edge.
Findings ink_at_border(const figure::Picture& picture);

}  // namespace tribolog::render::legibility
