#include "render/vector/vector_canvas.h"

#include <cmath>
#include <cstddef>

#include <fmt/format.h>

#include "render/figure/marks.h"

namespace tribolog::render::vector {

std::string short_number(double value, int digits) {
  if (!std::isfinite(value)) return "0";
  std::string text = fmt::format("{:.{}f}", value, digits);
  if (text.find('.') != std::string::npos) {
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
  }
  return text == "-0" ? "0" : text;
}

std::string place_of(figure::PixelPoint p) { return short_number(p.x) + " " + short_number(p.y); }

namespace {

using Points = VectorCanvas::Points;

Points outline_of(const figure::Ribbon& ribbon, std::size_t from, std::size_t to) {
  const auto part = [&](const Points& edge) {
    return Points(edge.begin() + static_cast<std::ptrdiff_t>(from),
                  edge.begin() + static_cast<std::ptrdiff_t>(to) + 1);
  };
  Points outline = part(ribbon.edge_a);
  const Points back = part(ribbon.edge_b);
  outline.insert(outline.end(), back.rbegin(), back.rend());
  return outline;
}

class ListPainter {
 public:
  explicit ListPainter(VectorCanvas& canvas) : canvas_(canvas) {}

  void operator()(const figure::Polyline& line) {
    if (line.points.size() > 1) {
      canvas_.stroke({line.points}, {line.width, line.colour, line.dashes});
    }
  }

  /// A band that turns back covers itself; each stretch between two turns is filled alone.
  void operator()(const figure::Ribbon& ribbon) {
    const Points& edge = ribbon.edge_a;
    if (edge.size() < 2) return;
    std::size_t from = 0;
    for (std::size_t i = 1; i + 1 < edge.size(); ++i) {
      const bool turns = (edge[i].x - edge[i - 1].x) * (edge[i + 1].x - edge[i].x) < 0;
      if (!turns) continue;
      canvas_.fill({outline_of(ribbon, from, i)}, ribbon.colour);
      from = i;
    }
    canvas_.fill({outline_of(ribbon, from, edge.size() - 1)}, ribbon.colour);
  }

  void operator()(const figure::Polygon& polygon) {
    if (polygon.outline.size() > 2) canvas_.fill({polygon.outline}, polygon.colour);
  }

  void operator()(const figure::Markers& markers) {
    if (markers.shape == figure::Marker::none || markers.centres.empty()) return;
    if (figure::has_rim(markers)) paint(markers, figure::marker_rim_colour, figure::marker_rim_px);
    paint(markers, markers.colour, 0.0);
  }

  void operator()(const figure::TextRun& run) {
    if (run.text.find_first_not_of(' ') != std::string::npos) canvas_.text(run);
  }

 private:
  void paint(const figure::Markers& markers, figure::Colour colour, double grow) {
    const double radius = figure::marker_radius(markers, grow);
    if (colour.alpha < 255) {  // where two lie on each other, both are seen
      for (const figure::PixelPoint& centre : markers.centres) {
        figure::Markers one = markers;
        one.centres = {centre};
        paint_as_one(one, colour, radius, grow);
      }
      return;
    }
    paint_as_one(markers, colour, radius, grow);
  }

  void paint_as_one(const figure::Markers& markers, figure::Colour colour, double radius,
                    double grow) {
    if (markers.shape == figure::Marker::circle) {
      canvas_.fill_discs(markers.centres, radius, colour);
      return;
    }
    std::vector<Points> parts;
    for (const figure::PixelPoint& centre : markers.centres) {
      if (!figure::is_stroked(markers.shape)) {
        parts.push_back(figure::marker_corners(markers.shape, centre, radius));
        continue;
      }
      for (const auto& [from, to] : figure::marker_strokes(markers, centre, grow).lines) {
        parts.push_back({from, to});
      }
    }
    if (figure::is_stroked(markers.shape)) {
      canvas_.stroke(parts, {figure::marker_strokes(markers, {}, grow).thickness, colour, {}});
    } else {
      canvas_.fill(parts, colour);
    }
  }

  VectorCanvas& canvas_;
};

}  // namespace

void paint_on(VectorCanvas& canvas, const figure::DrawList& list) {
  ListPainter painter(canvas);
  for (const figure::Primitive& primitive : list.primitives) std::visit(painter, primitive);
}

}  // namespace tribolog::render::vector
