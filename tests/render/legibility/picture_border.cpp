#include "render/legibility/picture_border.h"

#include <algorithm>
#include <string>

namespace tribolog::render::legibility {
namespace {

/// A PNG of few colours may stand for white with its neighbour.
bool is_paper(figure::Colour c) {
  constexpr int lightest_ink = 247;
  return std::min({c.red, c.green, c.blue}) > lightest_ink;
}

}  // namespace

Findings ink_at_border(const figure::Picture& picture) {
  Findings out;
  const auto look = [&](const char* edge, int from_x, int from_y, int step_x, int step_y,
                        int count) {
    for (int i = 0; i < count; ++i) {
      const int x = from_x + i * step_x;
      const int y = from_y + i * step_y;
      if (is_paper(picture.at(x, y))) continue;
      const figure::PixelPoint p{static_cast<double>(x), static_cast<double>(y)};
      out.push_back({std::string("ink at the ") + edge + " edge", {p.x, p.y, p.x + 1, p.y + 1}});
      return;
    }
  };
  look("upper", 0, 0, 1, 0, picture.width);
  look("lower", 0, picture.height - 1, 1, 0, picture.width);
  look("left", 0, 0, 0, 1, picture.height);
  look("right", picture.width - 1, 0, 0, 1, picture.height);
  return out;
}

}  // namespace tribolog::render::legibility
