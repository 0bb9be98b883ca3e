#include "render/scene/annotations.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "render/figure/draw_list.h"
#include "render/figure/scene.h"

namespace tribolog::render::scene {
namespace {

constexpr double arc_px = 3.0;
constexpr double dimension_px = 2.2;
constexpr double thin_px = 1.3;
constexpr double head_px = 20.0;
constexpr double arc_step_rad = 0.02;

figure::Point3 on_arc(const figure::SceneSector& sector, double angle) {
  return sector.centre + sector.radius_m * figure::turned(figure::unit(sector.zero),
                                                          figure::unit(sector.normal), angle);
}

class Drawing {
 public:
  Drawing(figure::DrawList& list, const figure::SceneView& view, const layout::FigureStyle& style)
      : list_(list), view_(view), unit_(style.unit) {}

  void draw(const figure::SceneSector& sector) {
    const double span = sector.to_rad - sector.from_rad;
    const int steps = std::max(2, static_cast<int>(std::ceil(std::abs(span) / arc_step_rad)));
    std::vector<figure::PixelPoint> arc;
    for (int i = 0; i <= steps; ++i) {
      arc.push_back(view_.pixel(on_arc(sector, sector.from_rad + span * i / steps)));
    }
    if (sector.ends == figure::ArcEnds::arrow_at_both) {
      std::reverse(arc.begin(), arc.end());
      end_in_head(arc, sector.colour);
      std::reverse(arc.begin(), arc.end());
    }
    if (sector.ends != figure::ArcEnds::plain) end_in_head(arc, sector.colour);
    stroke(std::move(arc), arc_px, sector.colour, figure::LineStyle::solid);
    ++index_;
  }

  void draw(const figure::SceneDimension& one) {
    const figure::PixelPoint a = view_.pixel(one.from + one.shift);
    const figure::PixelPoint b = view_.pixel(one.to + one.shift);
    lead(view_.pixel(one.from), a, one.colour);
    lead(view_.pixel(one.to), b, one.colour);
    std::vector<figure::PixelPoint> line{a, b};
    end_in_head(line, one.colour);
    std::reverse(line.begin(), line.end());
    end_in_head(line, one.colour);
    stroke(std::move(line), dimension_px, one.colour, figure::LineStyle::solid);
    ++index_;
  }

  void draw(const figure::SceneLine& line) {
    std::vector<figure::PixelPoint> points;
    for (const figure::Point3& p : line.points) points.push_back(view_.pixel(p));
    if (line.style != figure::LineStyle::none)
      stroke(std::move(points), line.width_px, line.colour, line.style);
    ++index_;
  }

 private:
  [[nodiscard]] figure::Owner owner() const { return {figure::Role::scene_line, 0, index_}; }

  void stroke(std::vector<figure::PixelPoint> points, double width, figure::Colour colour,
              figure::LineStyle style) {
    const double pixels = std::max(1.0, width * unit_);
    list_.primitives.emplace_back(figure::Polyline{owner(), std::move(points), pixels, colour,
                                                   figure::dash_lengths(style, pixels)});
  }

  /// From what is measured to a little beyond the dimension's line.
  void lead(figure::PixelPoint from, figure::PixelPoint to, figure::Colour colour) {
    const double size = std::hypot(to.x - from.x, to.y - from.y);
    if (size < 2) return;
    const double beyond = 1 + 8 * unit_ / size;
    stroke({from, {from.x + (to.x - from.x) * beyond, from.y + (to.y - from.y) * beyond}}, thin_px,
           colour, figure::LineStyle::solid);
  }

  /// A head whose tip is the line's last point; the line then ends inside of it.
  void end_in_head(std::vector<figure::PixelPoint>& line, figure::Colour colour) {
    const figure::PixelPoint tip = line.back();
    double all = 0;
    for (std::size_t i = 1; i < line.size(); ++i) {
      all += std::hypot(line[i].x - line[i - 1].x, line[i].y - line[i - 1].y);
    }
    const double size = std::min(head_px * unit_, 0.4 * all);
    if (!(size > 0)) return;
    const auto left = [&](figure::PixelPoint p) { return std::hypot(tip.x - p.x, tip.y - p.y); };
    while (line.size() > 1 && left(line.back()) < 0.8 * size) line.pop_back();
    const figure::PixelPoint before = line.back();
    const double share =
        std::clamp((left(before) - 0.8 * size) / std::max(1e-9, left(before)), 0.0, 1.0);
    const figure::PixelPoint base{before.x + (tip.x - before.x) * share,
                                  before.y + (tip.y - before.y) * share};
    line.push_back(base);
    const double along = std::max(1e-9, left(base));
    const figure::PixelPoint u{(tip.x - base.x) / along, (tip.y - base.y) / along};
    const figure::PixelPoint back{tip.x - u.x * size, tip.y - u.y * size};
    const double half = 0.32 * size;
    list_.primitives.emplace_back(figure::Polygon{owner(),
                                                  {tip,
                                                   {back.x - u.y * half, back.y + u.x * half},
                                                   {back.x + u.y * half, back.y - u.x * half}},
                                                  colour});
  }

  figure::DrawList& list_;
  const figure::SceneView& view_;
  double unit_;
  int index_{0};
};

}  // namespace

void draw_annotations(figure::DrawList& list, const figure::Scene& scene,
                      const figure::SceneView& view, const layout::FigureStyle& style) {
  Drawing drawing(list, view, style);
  for (const figure::SceneSector& one : scene.sectors) drawing.draw(one);
  for (const figure::SceneDimension& one : scene.dimensions) drawing.draw(one);
  for (const figure::SceneLine& one : scene.lines) drawing.draw(one);
}

std::vector<std::string> annotation_labels(const figure::Scene& scene) {
  std::vector<std::string> labels;
  for (const figure::SceneSector& one : scene.sectors) labels.push_back(one.label);
  for (const figure::SceneDimension& one : scene.dimensions) labels.push_back(one.label);
  for (const figure::SceneLine& one : scene.lines) labels.push_back(one.label);
  return labels;
}

figure::Point3 middle_of(const figure::SceneSector& sector) {
  return on_arc(sector, (sector.from_rad + sector.to_rad) / 2);
}

figure::Point3 middle_of(const figure::SceneDimension& dimension) {
  return 0.5 * (dimension.from + dimension.to) + dimension.shift;
}

figure::Point3 middle_of(const figure::SceneLine& line) {
  if (line.points.empty()) return {};
  return 0.5 * (line.points.front() + line.points.back());
}

}  // namespace tribolog::render::scene
