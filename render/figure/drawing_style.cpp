#include "render/figure/drawing_style.h"

#include <algorithm>
#include <cmath>

namespace tribolog::render::figure {

namespace {

double linear(std::uint8_t channel) {
  const double share = channel / 255.0;
  return share <= 0.04045 ? share / 12.92 : std::pow((share + 0.055) / 1.055, 2.4);
}

double luminance(Colour c) {
  return 0.2126 * linear(c.red) + 0.7152 * linear(c.green) + 0.0722 * linear(c.blue);
}

}  // namespace

double contrast_ratio(Colour a, Colour b) {
  const double one = luminance(a) + 0.05;
  const double other = luminance(b) + 0.05;
  return std::max(one, other) / std::min(one, other);
}

Colour readable_on_paper(Colour colour) {
  constexpr Colour paper{255, 255, 255};
  constexpr int steps = 50;
  for (int step = steps; step > 0; --step) {
    const auto darker = [&](std::uint8_t channel) {
      return static_cast<std::uint8_t>(channel * step / steps);
    };
    const Colour tried{darker(colour.red), darker(colour.green), darker(colour.blue), colour.alpha};
    if (contrast_ratio(tried, paper) >= least_text_contrast) return tried;
  }
  return palette::black;
}

}  // namespace tribolog::render::figure
