#include "paper/sketch_lines.h"

#include <algorithm>
#include <cmath>

namespace tribolog::paper {

std::vector<render::DiagramPoint> bent_bristle(render::DiagramPoint root, double length,
                                               double deflection) {
  constexpr int steps = 24;
  std::vector<render::DiagramPoint> points;
  for (int i = 0; i <= steps; ++i) {
    const double s = static_cast<double>(i) / steps;
    points.push_back({root.x + deflection * s * s * (3.0 - s) / 2.0, root.y + length * s});
  }
  return points;
}

std::vector<render::DiagramPoint> zigzag_spring(render::DiagramPoint from, render::DiagramPoint to,
                                                int turns, double half_width) {
  constexpr double straight_share = 0.18;
  const double dx = to.x - from.x;
  const double dy = to.y - from.y;
  const double length = std::hypot(dx, dy);
  const auto at = [&](double share, double beside) {
    return render::DiagramPoint{from.x + share * dx - beside * dy / length,
                                from.y + share * dy + beside * dx / length};
  };
  const int teeth = 2 * std::max(1, turns);
  std::vector<render::DiagramPoint> points{from, at(straight_share, 0)};
  for (int i = 0; i < teeth; ++i) {
    const double share = straight_share + (1 - 2 * straight_share) * (i + 0.5) / teeth;
    points.push_back(at(share, i % 2 == 0 ? half_width : -half_width));
  }
  points.push_back(at(1 - straight_share, 0));
  points.push_back(to);
  return points;
}

std::vector<render::DiagramPoint> upright_rectangle(double left, double top, double right,
                                                    double bottom) {
  return {{left, top}, {right, top}, {right, bottom}, {left, bottom}};
}

}  // namespace tribolog::paper
