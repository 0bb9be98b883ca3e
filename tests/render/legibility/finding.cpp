#include "render/legibility/finding.h"

#include <cmath>
#include <string>

namespace tribolog::render::legibility {

std::string in_words(const Finding& finding) {
  const auto pixel = [](double value) { return std::to_string(std::lround(value)); };
  const figure::PixelBox& at = finding.place;
  return finding.what + " at " + pixel(at.left) + ".." + pixel(at.right) + " x " + pixel(at.top) +
         ".." + pixel(at.bottom) + " px";
}

}  // namespace tribolog::render::legibility
