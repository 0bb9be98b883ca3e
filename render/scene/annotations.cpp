#include "render/scene/annotations.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "render/figure/marks.h"
#include "render/figure/scene.h"

namespace tribolog::render {
namespace {

constexpr double arc_px = 3.0;
constexpr double dimension_px = 2.2;
constexpr double thin_px = 1.3;
constexpr double head_px = 20.0;
constexpr double arc_step_rad = 0.02;

Point3 on_arc(const SceneSector& sector, double angle) {
  return sector.centre + sector.radius_m * turned(unit(sector.zero), unit(sector.normal), angle);
}

class Drawing {
 public:
  Drawing(DrawList& list, const SceneView& view, const FigureStyle& style)
      : list_(list), view_(view), unit_(style.unit) {}

  void draw(const SceneSector& sector) {
    const double span = sector.to_rad - sector.from_rad;
    const int steps = std::max(2, static_cast<int>(std::ceil(std::abs(span) / arc_step_rad)));
    std::vector<PixelPoint> arc;
    for (int i = 0; i <= steps; ++i) {
      arc.push_back(view_.pixel(on_arc(sector, sector.from_rad + span * i / steps)));
    }
    if (sector.ends == ArcEnds::arrow_at_both) {
      std::reverse(arc.begin(), arc.end());
      end_in_head(arc, sector.colour);
      std::reverse(arc.begin(), arc.end());
    }
    if (sector.ends != ArcEnds::plain) end_in_head(arc, sector.colour);
    stroke(std::move(arc), arc_px, sector.colour, LineStyle::solid);
    ++index_;
  }

  void draw(const SceneDimension& one) {
    const PixelPoint a = view_.pixel(one.from + one.shift);
    const PixelPoint b = view_.pixel(one.to + one.shift);
    lead(view_.pixel(one.from), a, one.colour);
    lead(view_.pixel(one.to), b, one.colour);
    std::vector<PixelPoint> line{a, b};
    end_in_head(line, one.colour);
    std::reverse(line.begin(), line.end());
    end_in_head(line, one.colour);
    stroke(std::move(line), dimension_px, one.colour, LineStyle::solid);
    ++index_;
  }

  void draw(const SceneLine& line) {
    std::vector<PixelPoint> points;
    for (const Point3& p : line.points) points.push_back(view_.pixel(p));
    if (line.style != LineStyle::none)
      stroke(std::move(points), line.width_px, line.colour, line.style);
    ++index_;
  }

 private:
  [[nodiscard]] Owner owner() const { return {Role::scene_line, 0, index_}; }

  void stroke(std::vector<PixelPoint> points, double width, Colour colour, LineStyle style) {
    const double pixels = std::max(1.0, width * unit_);
    list_.primitives.emplace_back(
        Polyline{owner(), std::move(points), pixels, colour, dash_lengths(style, pixels)});
  }

  /// From what is measured to a little beyond the dimension's line.
  void lead(PixelPoint from, PixelPoint to, Colour colour) {
    const double size = std::hypot(to.x - from.x, to.y - from.y);
    if (size < 2) return;
    const double beyond = 1 + 8 * unit_ / size;
    stroke({from, {from.x + (to.x - from.x) * beyond, from.y + (to.y - from.y) * beyond}}, thin_px,
           colour, LineStyle::solid);
  }

  /// A head whose tip is the line's last point; the line then ends inside of it.
  void end_in_head(std::vector<PixelPoint>& line, Colour colour) {
    const PixelPoint tip = line.back();
    double all = 0;
    for (std::size_t i = 1; i < line.size(); ++i) {
      all += std::hypot(line[i].x - line[i - 1].x, line[i].y - line[i - 1].y);
    }
    const double size = std::min(head_px * unit_, 0.4 * all);
    if (!(size > 0)) return;
    const auto left = [&](PixelPoint p) { return std::hypot(tip.x - p.x, tip.y - p.y); };
    while (line.size() > 1 && left(line.back()) < 0.8 * size) line.pop_back();
    const PixelPoint before = line.back();
    const double share =
        std::clamp((left(before) - 0.8 * size) / std::max(1e-9, left(before)), 0.0, 1.0);
    const PixelPoint base{before.x + (tip.x - before.x) * share,
                          before.y + (tip.y - before.y) * share};
    line.push_back(base);
    const double along = std::max(1e-9, left(base));
    const PixelPoint u{(tip.x - base.x) / along, (tip.y - base.y) / along};
    const PixelPoint back{tip.x - u.x * size, tip.y - u.y * size};
    const double half = 0.32 * size;
    list_.primitives.emplace_back(Polygon{owner(),
                                          {tip,
                                           {back.x - u.y * half, back.y + u.x * half},
                                           {back.x + u.y * half, back.y - u.x * half}},
                                          colour});
  }

  DrawList& list_;
  const SceneView& view_;
  double unit_;
  int index_{0};
};

}  // namespace

void draw_annotations(DrawList& list, const Scene& scene, const SceneView& view,
                      const FigureStyle& style) {
  Drawing drawing(list, view, style);
  for (const SceneSector& one : scene.sectors) drawing.draw(one);
  for (const SceneDimension& one : scene.dimensions) drawing.draw(one);
  for (const SceneLine& one : scene.lines) drawing.draw(one);
}

std::vector<std::string> annotation_labels(const Scene& scene) {
  std::vector<std::string> labels;
  for (const SceneSector& one : scene.sectors) labels.push_back(one.label);
  for (const SceneDimension& one : scene.dimensions) labels.push_back(one.label);
  for (const SceneLine& one : scene.lines) labels.push_back(one.label);
  return labels;
}

Point3 middle_of(const SceneSector& sector) {
  return on_arc(sector, (sector.from_rad + sector.to_rad) / 2);
}

Point3 middle_of(const SceneDimension& dimension) {
  return 0.5 * (dimension.from + dimension.to) + dimension.shift;
}

Point3 middle_of(const SceneLine& line) {
  if (line.points.empty()) return {};
  return 0.5 * (line.points.front() + line.points.back());
}

}  // namespace tribolog::render
