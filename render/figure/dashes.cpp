#include "render/figure/dashes.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tribolog::render {

std::vector<double> dash_lengths(LineStyle style, double width) {
  const double unit = std::max(width, 1.5);
  const double dash = 5.0 * unit;
  const double dot = 1.3 * unit;
  const double gap = 2.4 * unit;
  switch (style) {
    case LineStyle::dash:
      return {dash, gap};
    case LineStyle::dot:
      return {dot, 1.6 * unit};
    case LineStyle::dash_dot:
      return {1.4 * dash, gap, dot, gap};
    case LineStyle::dash_dot_dot:
      return {1.4 * dash, gap, dot, gap, dot, gap};
    case LineStyle::none:
    case LineStyle::solid:
      break;
  }
  return {};
}

std::vector<std::vector<PixelPoint>> cut_into_dashes(const std::vector<PixelPoint>& line,
                                                     const std::vector<double>& lengths) {
  if (lengths.empty()) return {line};
  std::vector<std::vector<PixelPoint>> out;
  std::vector<PixelPoint> dash;
  std::size_t phase = 0;
  double remaining = lengths[0];
  if (!line.empty()) dash.push_back(line.front());
  for (std::size_t i = 1; i < line.size(); ++i) {
    const PixelPoint from = line[i - 1];
    const PixelPoint to = line[i];
    const double length = std::hypot(to.x - from.x, to.y - from.y);
    double done = 0.0;
    while (length - done > remaining) {
      done += remaining;
      const double t = done / length;
      const PixelPoint here{from.x + t * (to.x - from.x), from.y + t * (to.y - from.y)};
      dash.push_back(here);
      if (phase % 2 == 0) out.push_back(std::exchange(dash, {}));
      dash.assign(1, here);
      phase = (phase + 1) % lengths.size();
      remaining = lengths[phase];
    }
    remaining -= length - done;
    if (phase % 2 == 0) dash.push_back(to);
  }
  if (phase % 2 == 0 && dash.size() > 1) out.push_back(std::move(dash));
  return out;
}

}  // namespace tribolog::render
