#pragma once
// Letters as large as they are in print.

#include "render/figure/draw_list.h"
#include "render/legibility/finding.h"

namespace tribolog::render::legibility {

/// Texts with letters of less than so many points where the figure has its width in print. Indices
/// and exponents go with their letters.
Findings small_letters(const figure::DrawList& list, double least_pt);

}  // namespace tribolog::render::legibility
