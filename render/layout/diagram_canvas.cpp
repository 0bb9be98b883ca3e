#include "render/layout/diagram_canvas.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tribolog::render::layout {
namespace {

constexpr double designed_px_per_mm = 10.0;
constexpr double head_length_mm = 2.6;
constexpr double head_half_width_share = 0.385;  // of the length
constexpr double text_gap_mm = 1.0;
constexpr double capital_height = 0.73;  // of an em

std::vector<double> dashes_of(figure::LineStyle style, double width) {
  const double dash = 4.0 * width;
  const double gap = 2.6 * width;
  switch (style) {
    case figure::LineStyle::dash:
      return {dash, gap};
    case figure::LineStyle::dot:
      return {width, gap};
    case figure::LineStyle::dash_dot:
      return {dash, gap, width, gap};
    case figure::LineStyle::dash_dot_dot:
      return {dash, gap, width, gap, width, gap};
    default:
      return {};
  }
}

}  // namespace

DiagramCanvas::DiagramCanvas(figure::DrawList& list, const figure::Diagram& diagram,
                             const figure::PixelBox& room, const text::Font& font,
                             double most_px_per_mm)
    : list_(list),
      font_(font),
      px_per_mm_(std::min({room.width() / std::max(1.0, diagram.width),
                           room.height() / std::max(1.0, diagram.height), most_px_per_mm})) {
  const double width = px_per_mm_ * diagram.width;
  const double height = px_per_mm_ * diagram.height;
  const figure::PixelPoint middle = room.centre();
  area_ = {middle.x - width / 2, middle.y - height / 2, middle.x + width / 2,
           middle.y + height / 2};
}

figure::PixelPoint DiagramCanvas::pixel(figure::DiagramPoint p) const {
  return {area_.left + px_per_mm_ * p.x, area_.top + px_per_mm_ * p.y};
}

std::vector<figure::PixelPoint> DiagramCanvas::pixels(
    const std::vector<figure::DiagramPoint>& points) const {
  std::vector<figure::PixelPoint> out;
  for (const figure::DiagramPoint& p : points) out.push_back(pixel(p));
  return out;
}

figure::PixelBox DiagramCanvas::box(figure::DiagramPoint centre, double width,
                                    double height) const {
  const figure::PixelPoint c = pixel(centre);
  return {c.x - length(width) / 2, c.y - length(height) / 2, c.x + length(width) / 2,
          c.y + length(height) / 2};
}

double DiagramCanvas::line_width(double designed_px) const {
  return std::max(1.0, designed_px * px_per_mm_ / designed_px_per_mm);
}

void DiagramCanvas::line(figure::Owner owner, std::vector<figure::PixelPoint> points,
                         double designed_px, figure::Colour colour, figure::LineStyle style) {
  const double width = line_width(designed_px);
  list_.primitives.emplace_back(
      figure::Polyline{owner, std::move(points), width, colour, dashes_of(style, width)});
}

void DiagramCanvas::filled(figure::Owner owner, std::vector<figure::PixelPoint> outline,
                           figure::Colour colour) {
  list_.primitives.emplace_back(figure::Polygon{owner, std::move(outline), colour});
}

double DiagramCanvas::head_length(double designed_px) const {
  return length(head_length_mm) * std::max(1.0, std::sqrt(designed_px / diagram_line_px));
}

void DiagramCanvas::head(figure::Owner owner, figure::PixelPoint behind, figure::PixelPoint& tip,
                         double designed_px, figure::Colour colour) {
  const double norm = std::hypot(tip.x - behind.x, tip.y - behind.y);
  if (norm < 1e-6) return;
  const figure::PixelPoint along{(tip.x - behind.x) / norm, (tip.y - behind.y) / norm};
  const double size = head_length(designed_px);
  const double half = head_half_width_share * size;
  const figure::PixelPoint base{tip.x - along.x * size, tip.y - along.y * size};
  filled(owner,
         {tip,
          {base.x - along.y * half, base.y + along.x * half},
          {base.x + along.y * half, base.y - along.x * half}},
         colour);
  tip = {tip.x - along.x * 0.7 * size, tip.y - along.y * 0.7 * size};
}

text::TextLine DiagramCanvas::shape(const std::string& text, double size_mm, bool bold,
                                    figure::Colour colour) {
  text::TextStyle style;
  style.size_px = std::max(8, static_cast<int>(std::lround(length(size_mm))));
  style.weight = bold ? text::Weight::bold : text::Weight::regular;
  style.colour = colour == figure::palette::black ? ink::text : colour;
  return text::shape_line(font_, text, style, faults_);
}

void DiagramCanvas::text(figure::Owner owner, const text::TextLine& line, figure::PixelPoint at,
                         figure::TextPlace place, const std::string& markup, int block) {
  if (line.empty()) return;
  const double gap = length(text_gap_mm);
  figure::PixelPoint start{at.x - line.width / 2, at.y + capital_height * line.style.size_px / 2};
  switch (place) {
    case figure::TextPlace::centre:
      break;
    case figure::TextPlace::left:
      start.x = at.x - gap - line.width;
      break;
    case figure::TextPlace::right:
      start.x = at.x + gap;
      break;
    case figure::TextPlace::above:
      start.y = at.y - gap - line.descent;
      break;
    case figure::TextPlace::below:
      start.y = at.y + gap + line.ascent;
      break;
  }
  texts_.push_back({markup, text::place_line(list_, line, start, true, owner), block});
}

}  // namespace tribolog::render::layout
