#include "render/layout/line_geometry.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace tribolog::render {
namespace {

double distance(PixelPoint p, PixelPoint a, PixelPoint b) {
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  const double square = dx * dx + dy * dy;
  const double share =
      square > 0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / square, 0.0, 1.0) : 0.0;
  return std::hypot(p.x - a.x - share * dx, p.y - a.y - share * dy);
}

}  // namespace

bool lies_on(const std::vector<PixelPoint>& line, PixelPoint p, double reach) {
  for (std::size_t i = 1; i < line.size(); ++i) {
    if (distance(p, line[i - 1], line[i]) <= reach) return true;
  }
  return false;
}

// Liang and Barsky's clipping.
bool enters(const std::vector<PixelPoint>& line, const PixelBox& box) {
  for (std::size_t i = 1; i < line.size(); ++i) {
    const PixelPoint& a = line[i - 1];
    const double dx = line[i].x - a.x;
    const double dy = line[i].y - a.y;
    double from = 0;
    double to = 1;
    const auto clip = [&](double slope, double room) {
      if (std::abs(slope) < 1e-12) {
        if (room <= 0) to = -1;
      } else if (slope > 0) {
        to = std::min(to, room / slope);
      } else {
        from = std::max(from, room / slope);
      }
    };
    clip(-dx, a.x - box.left);
    clip(dx, box.right - a.x);
    clip(-dy, a.y - box.top);
    clip(dy, box.bottom - a.y);
    if (from < to) return true;
  }
  return false;
}

}  // namespace tribolog::render
