#pragma once
// How well colours are told from their ground, as the Web Content Accessibility Guidelines
// measure it.

#include "render/figure/drawing_style.h"

namespace tribolog::render {

inline constexpr double least_text_contrast = 4.5;  ///< WCAG 2.1, 1.4.3.
inline constexpr double least_line_contrast = 3.0;  ///< WCAG 2.1, 1.4.11.

/// (L1 + 0.05) / (L2 + 0.05) of the relative luminances, the lighter one first: 1 to 21. Both
/// opaque.
double contrast_ratio(Colour a, Colour b);

/// The colour, darkened as far as letters in it need to be read on white paper.
Colour readable_on_paper(Colour colour);

}  // namespace tribolog::render
