#include "render/check/visibility_map.h"

#include <algorithm>
#include <cmath>

#include "render/figure/draw_list.h"

namespace tribolog::render::check {
namespace {

constexpr double touch = 1.0;    // pixels beside an edge that antialiasing may tint
constexpr double inside = 0.75;  // a pixel this far inside an edge is wholly covered
constexpr double least_core = 0.35;

figure::PixelBox bounds(const std::vector<figure::PixelPoint>& outline) {
  figure::PixelBox box{1e9, 1e9, -1e9, -1e9};
  for (const figure::PixelPoint& p : outline) {
    box = {std::min(box.left, p.x), std::min(box.top, p.y), std::max(box.right, p.x),
           std::max(box.bottom, p.y)};
  }
  return box;
}

}  // namespace

VisibilityMap::VisibilityMap(const figure::DrawList& list)
    : width_(list.width),
      height_(list.height),
      pixels_(static_cast<std::size_t>(list.width) * static_cast<std::size_t>(list.height)) {
  for (const figure::Primitive& primitive : list.primitives) paint(primitive);
}

std::uint16_t VisibilityMap::number_of(const figure::Primitive& primitive) {
  figure::Owner owner = figure::owner_of(primitive);
  if (owner.role == figure::Role::series_marker || owner.role == figure::Role::direction_arrow) {
    owner.role = figure::Role::series;
  }
  const bool is_subject = owner.role == figure::Role::series || owner.role == figure::Role::band ||
                          owner.role == figure::Role::block || owner.role == figure::Role::wire ||
                          owner.role == figure::Role::scene_line;
  if (!is_subject) return 0;
  for (std::size_t i = 0; i < subjects_.size(); ++i) {
    if (subjects_[i].owner == owner) return static_cast<std::uint16_t>(i + 1);
  }
  const figure::Colour colour =
      std::visit([](const auto& one) -> figure::Colour { return one.colour; }, primitive);
  subjects_.push_back({owner, colour, 0});
  return static_cast<std::uint16_t>(subjects_.size());
}

void VisibilityMap::paint(const figure::Primitive& primitive) {
  const std::uint16_t number = number_of(primitive);
  if (const auto* line = std::get_if<figure::Polyline>(&primitive)) {
    for (const auto& dash : figure::cut_into_dashes(line->points, line->dashes)) {
      stroke(dash, line->width, number);
    }
  } else if (const auto* area = std::get_if<figure::Ribbon>(&primitive)) {
    ribbon(*area, number);
  } else if (const auto* polygon = std::get_if<figure::Polygon>(&primitive)) {
    box(bounds(polygon->outline).grown(touch), 0);
  } else if (const auto* all = std::get_if<figure::Markers>(&primitive)) {
    markers(*all, number);
  } else if (const auto* run = std::get_if<figure::TextRun>(&primitive)) {
    box(run->box.grown(touch + 1), 0);
  }
}

void VisibilityMap::row(int y, double from, double to, std::uint16_t number) {
  if (y < 0 || y >= height_) return;
  // Pixel centres lie at halves.
  const int first = std::max(0, static_cast<int>(std::ceil(std::max(from - 0.5, -1.0))));
  const int last =
      std::min(width_ - 1, static_cast<int>(std::floor(std::min(to - 0.5, width_ + 1.0))));
  if (first > last) return;
  const std::ptrdiff_t start = static_cast<std::ptrdiff_t>(y) * width_;
  std::fill(pixels_.begin() + start + first, pixels_.begin() + start + last + 1, number);
  if (number > 0) subjects_[number - 1U].painted += static_cast<std::size_t>(last - first + 1);
}

void VisibilityMap::box(const figure::PixelBox& area, std::uint16_t number) {
  const int top = std::max(0, static_cast<int>(std::floor(area.top)));
  const int bottom = std::min(height_ - 1, static_cast<int>(std::ceil(area.bottom)));
  for (int y = top; y <= bottom; ++y) {
    if (y + 0.5 >= area.top && y + 0.5 <= area.bottom) row(y, area.left, area.right, number);
  }
}

/// Pixels whose centre is within `half` of the segment, which is longer by `extra` at both ends.
void VisibilityMap::bar(figure::PixelPoint a, figure::PixelPoint b, double half, double extra,
                        std::uint16_t number) {
  const double length = std::hypot(b.x - a.x, b.y - a.y);
  if (length < 1e-9 || half <= 0) return;
  const double ux = (b.x - a.x) / length;
  const double uy = (b.y - a.y) / length;
  const double reach = half + std::max(0.0, extra);
  const int top = std::max(0, static_cast<int>(std::floor(std::min(a.y, b.y) - reach)));
  const int bottom = std::min(height_ - 1, static_cast<int>(std::ceil(std::max(a.y, b.y) + reach)));
  for (int y = top; y <= bottom; ++y) {
    const double dy = y + 0.5 - a.y;
    double from = -1e9;
    double to = 1e9;
    // low <= dx * slope + offset <= high bounds dx.
    const auto bound = [&](double slope, double offset, double low, double high) {
      if (std::abs(slope) < 1e-9) {
        if (offset < low || offset > high) to = from - 1;
        return;
      }
      const double p = (low - offset) / slope;
      const double q = (high - offset) / slope;
      from = std::max(from, std::min(p, q));
      to = std::min(to, std::max(p, q));
    };
    bound(-uy, dy * ux, -half, half);
    bound(ux, dy * uy, -extra, length + extra);
    if (from <= to) row(y, a.x + from, a.x + to, number);
  }
}

void VisibilityMap::stroke(const std::vector<figure::PixelPoint>& line, double width,
                           std::uint16_t number) {
  const double half = width / 2;
  for (std::size_t i = 1; i < line.size(); ++i) {
    bar(line[i - 1], line[i], half + touch, half + touch, 0);
  }
  if (number == 0) return;
  const double core = std::max(half - inside, least_core);
  for (std::size_t i = 1; i < line.size(); ++i) {
    // Inner joints are covered by both segments; the ends of the whole line may be cut short.
    bar(line[i - 1], line[i], core, -0.5, number);
  }
}

void VisibilityMap::disc(figure::PixelPoint centre, double radius, std::uint16_t number) {
  const int top = std::max(0, static_cast<int>(std::floor(centre.y - radius)));
  const int bottom = std::min(height_ - 1, static_cast<int>(std::ceil(centre.y + radius)));
  for (int y = top; y <= bottom; ++y) {
    const double up = y + 0.5 - centre.y;
    if (std::abs(up) > radius) continue;
    const double half = std::sqrt(radius * radius - up * up);
    row(y, centre.x - half, centre.x + half, number);
  }
}

void VisibilityMap::markers(const figure::Markers& all, std::uint16_t number) {
  const bool solid = all.shape != figure::Marker::cross && all.shape != figure::Marker::plus;
  const bool round = all.shape == figure::Marker::circle;
  // Corners stand out of the circle of the same area; a rim and antialiasing add to it.
  const double reach = (round ? 0.5 : 0.75) * all.size + 2.5;
  for (const figure::PixelPoint& c : all.centres) disc(c, reach, 0);
  const double widest_inside = (round ? 0.5 : 0.35) * all.size - inside;
  const double core = solid ? std::max(widest_inside, 0.6) : 0.7;
  for (const figure::PixelPoint& c : all.centres) {
    if (number > 0) disc(c, core, number);
  }
}

void VisibilityMap::ribbon(const figure::Ribbon& one, std::uint16_t number) {
  for (std::size_t i = 1; i < one.edge_a.size(); ++i) {
    const figure::PixelPoint& a0 = one.edge_a[i - 1];
    const figure::PixelPoint& a1 = one.edge_a[i];
    const figure::PixelPoint& b0 = one.edge_b[i - 1];
    const figure::PixelPoint& b1 = one.edge_b[i];
    const double left = std::min(a0.x, a1.x);
    const double right = std::max(a0.x, a1.x);
    box(figure::PixelBox{left, std::min({a0.y, a1.y, b0.y, b1.y}), right,
                         std::max({a0.y, a1.y, b0.y, b1.y})}
            .grown(touch),
        0);
    const double top = std::max(std::min(a0.y, b0.y), std::min(a1.y, b1.y));
    const double bottom = std::min(std::max(a0.y, b0.y), std::max(a1.y, b1.y));
    if (number > 0 && top + 2 * inside < bottom) {
      box({left, top + inside, right, bottom - inside}, number);
    }
  }
}

}  // namespace tribolog::render::check
