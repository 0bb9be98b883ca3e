#include "paper/drawings/sketch_lines.h"

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

std::vector<render::DiagramPoint> upright_rectangle(double left, double top, double right,
                                                    double bottom) {
  return {{left, top}, {right, top}, {right, bottom}, {left, bottom}};
}

}  // namespace tribolog::paper
