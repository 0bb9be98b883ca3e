#pragma once
// What a reader of a figure would stumble over, found in its draw list.

#include <string>
#include <vector>

#include "render/figure/draw_list.h"

namespace tribolog::render::legibility {

/// `place` is in pixels of the figure.
struct Finding {
  std::string what;
  figure::PixelBox place;
};

using Findings = std::vector<Finding>;

/// "the text 'B' lies over 'A' at 120..180 x 40..62 px"
std::string in_words(const Finding& finding);

}  // namespace tribolog::render::legibility
