#include "render/legibility/contrast.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "render/figure/drawing_style.h"
#include "render/legibility/texts_of_list.h"

namespace tribolog::render::legibility {
namespace {

constexpr figure::Colour paper{255, 255, 255};
constexpr int probes = 12;               // along a text, and three across
constexpr double usual_width_mm = 0.17;  // of a curve in print, where it is thinnest

std::string text_of(double ratio) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.2f : 1", ratio);
  return buffer;
}

std::string text_of(figure::Colour c) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "#%02x%02x%02x", c.red, c.green, c.blue);
  return buffer;
}

bool is_inside(const std::vector<figure::PixelPoint>& outline, figure::PixelPoint p) {
  bool inside = false;
  for (std::size_t i = 0, j = outline.size() - 1; i < outline.size(); j = i++) {
    const figure::PixelPoint& a = outline[i];
    const figure::PixelPoint& b = outline[j];
    if ((a.y > p.y) != (b.y > p.y) && p.x < (b.x - a.x) * (p.y - a.y) / (b.y - a.y) + a.x) {
      inside = !inside;
    }
  }
  return inside;
}

std::vector<figure::PixelPoint> outline_of(const figure::Ribbon& ribbon) {
  std::vector<figure::PixelPoint> out = ribbon.edge_a;
  out.insert(out.end(), ribbon.edge_b.rbegin(), ribbon.edge_b.rend());
  return out;
}

/// What was filled at a point before the primitive `painted`.
figure::Colour ground_at(const figure::DrawList& list, figure::PixelPoint p, std::size_t painted) {
  figure::Colour ground = paper;
  for (std::size_t i = 0; i < painted; ++i) {
    if (const auto* polygon = std::get_if<figure::Polygon>(&list.primitives[i])) {
      if (is_inside(polygon->outline, p)) ground = laid_on(ground, polygon->colour);
    } else if (const auto* ribbon = std::get_if<figure::Ribbon>(&list.primitives[i])) {
      if (is_inside(outline_of(*ribbon), p)) ground = laid_on(ground, ribbon->colour);
    }
  }
  return ground;
}

double worst_contrast(const figure::DrawList& list, const ShownText& text) {
  double worst = 21;
  for (int i = 0; i < probes; ++i) {
    for (int k = 0; k < 3; ++k) {
      const figure::PixelPoint p{text.box.left + (i + 0.5) / probes * text.box.width(),
                                 text.box.top + (k + 0.5) / 3 * text.box.height()};
      const figure::Colour ground = ground_at(list, p, text.painted);
      worst = std::min(worst, figure::contrast_ratio(laid_on(ground, text.colour), ground));
    }
  }
  return worst;
}

bool must_be_seen(figure::Role role) {
  static const std::set<figure::Role> seen{
      figure::Role::axis,       figure::Role::series,       figure::Role::series_marker,
      figure::Role::error_bar,  figure::Role::label_marker, figure::Role::reference_line,
      figure::Role::block,      figure::Role::wire,         figure::Role::wire_head,
      figure::Role::branch_dot, figure::Role::shape,        figure::Role::scene_line};
  return seen.count(role) > 0;
}

bool is_light_by_choice(figure::Colour colour) {
  const figure::Colour light[] = {figure::palette::orange, figure::palette::sky_blue,
                                  figure::palette::yellow};
  return std::find(std::begin(light), std::end(light), colour) != std::end(light);
}

/// Colour, and whether anything but the colour tells the line.
struct Stroke {
  figure::Colour colour;
  bool is_told{};
  figure::PixelBox place;
};

std::optional<Stroke> stroke_of(const figure::DrawList& list, const figure::Primitive& primitive) {
  if (const auto* line = std::get_if<figure::Polyline>(&primitive)) {
    const double width_mm = line->width * list.width_mm / list.width;
    const figure::PixelPoint p = line->points.empty() ? figure::PixelPoint{} : line->points.front();
    return Stroke{
        line->colour, !line->dashes.empty() || width_mm >= usual_width_mm, {p.x, p.y, p.x, p.y}};
  }
  if (const auto* markers = std::get_if<figure::Markers>(&primitive)) {
    const figure::PixelPoint p =
        markers->centres.empty() ? figure::PixelPoint{} : markers->centres.front();
    return Stroke{markers->colour, true, {p.x, p.y, p.x, p.y}};
  }
  return std::nullopt;
}

double contrast_on_paper(figure::Colour colour) {
  return figure::contrast_ratio(laid_on(paper, colour), paper);
}

/// Whether a curve or marker that is seen well is painted over it in the same panel.
bool is_under_a_clear_one(const figure::DrawList& list, std::size_t painted) {
  const figure::Owner& own = figure::owner_of(list.primitives[painted]);
  for (std::size_t i = painted + 1; i < list.primitives.size(); ++i) {
    const figure::Owner& owner = figure::owner_of(list.primitives[i]);
    const bool is_data =
        owner.role == figure::Role::series || owner.role == figure::Role::series_marker;
    if (!is_data || owner.panel != own.panel) continue;
    const auto stroke = stroke_of(list, list.primitives[i]);
    if (stroke && contrast_on_paper(stroke->colour) >= figure::least_line_contrast) return true;
  }
  return false;
}

}  // namespace

figure::Colour laid_on(figure::Colour ground, figure::Colour colour) {
  const double cover = colour.alpha / 255.0;
  const auto mixed = [&](std::uint8_t below, std::uint8_t above) {
    return static_cast<std::uint8_t>(std::lround(below + cover * (above - below)));
  };
  return {mixed(ground.red, colour.red), mixed(ground.green, colour.green),
          mixed(ground.blue, colour.blue)};
}

Findings faint_texts(const figure::DrawList& list) {
  Findings out;
  for (const ShownText& text : texts_of(list)) {
    const double ratio = worst_contrast(list, text);
    if (ratio >= figure::least_text_contrast) continue;
    out.push_back({"the text '" + text.words + "' in " + text_of(text.colour) +
                       " has a contrast of " + text_of(ratio),
                   text.box});
  }
  return out;
}

Findings faint_lines(const figure::DrawList& list) {
  Findings out;
  std::set<std::string> told;
  for (std::size_t i = 0; i < list.primitives.size(); ++i) {
    const figure::Primitive& primitive = list.primitives[i];
    if (!must_be_seen(figure::owner_of(primitive).role)) continue;
    const auto stroke = stroke_of(list, primitive);
    if (!stroke) continue;
    const double ratio = contrast_on_paper(stroke->colour);
    if (ratio >= figure::least_line_contrast) continue;
    if (is_light_by_choice(stroke->colour) ? stroke->is_told : is_under_a_clear_one(list, i)) {
      continue;
    }
    const std::string what = "a line in " + text_of(stroke->colour) + " (" +
                             std::to_string(figure::owner_of(primitive).index + 1) + " of panel " +
                             std::to_string(figure::owner_of(primitive).panel + 1) +
                             ") has a contrast of " + text_of(ratio);
    if (told.insert(what).second) out.push_back({what, stroke->place});
  }
  return out;
}

}  // namespace tribolog::render::legibility
