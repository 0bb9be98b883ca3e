#include "render/legibility/letter_sizes.h"

#include <cstdio>

#include "render/legibility/texts_of_list.h"

namespace tribolog::render::legibility {

Findings small_letters(const figure::DrawList& list, double least_pt) {
  constexpr double points_per_mm = 72 / 25.4;
  constexpr double rounding_px = 0.5;  // sizes are whole pixels
  Findings out;
  const double points_per_px = list.width_mm / list.width * points_per_mm;
  for (const ShownText& text : texts_of(list)) {
    const double size_pt = text.letter_px * points_per_px;
    if (size_pt + rounding_px * points_per_px >= least_pt) continue;
    char size[32];
    std::snprintf(size, sizeof size, "%.2f pt", size_pt);
    out.push_back({"the text '" + text.words + "' has letters of " + size, text.box});
  }
  return out;
}

}  // namespace tribolog::render::legibility
