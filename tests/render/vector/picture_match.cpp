#include "render/vector/picture_match.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <variant>
#include <vector>

namespace tribolog::render {
namespace {

constexpr int reach = 2;
constexpr int tolerance = 40;  // of 255, after smoothing

bool alike(figure::Colour a, figure::Colour b, int within) {
  return std::abs(a.red - b.red) <= within && std::abs(a.green - b.green) <= within &&
         std::abs(a.blue - b.blue) <= within;
}

figure::Picture smoothed(const figure::Picture& in) {
  figure::Picture out = in;
  const int row = 3 * in.width;
  for (int y = 1; y + 1 < in.height; ++y) {
    for (int i = 3; i + 3 < row; ++i) {
      const std::size_t at =
          static_cast<std::size_t>(y) * static_cast<std::size_t>(row) + static_cast<std::size_t>(i);
      int sum = 0;
      for (const int dy : {-row, 0, row}) {
        for (const int dx : {-3, 0, 3}) {
          sum += in.rgb[static_cast<std::size_t>(static_cast<std::ptrdiff_t>(at) + dy + dx)];
        }
      }
      out.rgb[at] = static_cast<std::uint8_t>(sum / 9);
    }
  }
  return out;
}

bool has_near(const figure::Picture& picture, int x, int y, figure::Colour wanted, int within) {
  if (alike(picture.at(x, y), wanted, within)) return true;
  for (int v = std::max(0, y - reach); v <= std::min(picture.height - 1, y + reach); ++v) {
    for (int u = std::max(0, x - reach); u <= std::min(picture.width - 1, x + reach); ++u) {
      if (alike(picture.at(u, v), wanted, within)) return true;
    }
  }
  return false;
}

std::size_t unmatched(const figure::Picture& a, const figure::Picture& b) {
  std::size_t count = 0;
  for (int y = 0; y < a.height; ++y) {
    for (int x = 0; x < a.width; ++x) count += has_near(b, x, y, a.at(x, y), tolerance) ? 0 : 1;
  }
  return count;
}

/// Where a primitive should show its colour.
std::vector<figure::PixelPoint> samples_of(const figure::Primitive& primitive) {
  constexpr double step = 5.0;
  std::vector<figure::PixelPoint> out;
  if (const auto* line = std::get_if<figure::Polyline>(&primitive)) {
    for (std::size_t i = 1; i < line->points.size(); ++i) {
      const figure::PixelPoint a = line->points[i - 1];
      const figure::PixelPoint b = line->points[i];
      const int steps = static_cast<int>(std::hypot(b.x - a.x, b.y - a.y) / step) + 1;
      for (int k = 0; k < steps; ++k) {
        const double t = (k + 0.5) / steps;
        out.push_back({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)});
      }
    }
  } else if (const auto* ribbon = std::get_if<figure::Ribbon>(&primitive)) {
    for (std::size_t i = 0; i < ribbon->edge_a.size(); ++i) {
      out.push_back({(ribbon->edge_a[i].x + ribbon->edge_b[i].x) / 2,
                     (ribbon->edge_a[i].y + ribbon->edge_b[i].y) / 2});
    }
  } else if (const auto* polygon = std::get_if<figure::Polygon>(&primitive)) {
    figure::PixelPoint sum;
    for (const figure::PixelPoint& p : polygon->outline) sum = {sum.x + p.x, sum.y + p.y};
    const auto count = static_cast<double>(polygon->outline.size());
    out.push_back({sum.x / count, sum.y / count});
  } else if (const auto* markers = std::get_if<figure::Markers>(&primitive)) {
    out = markers->centres;
  }
  return out;
}

figure::Colour on_white(figure::Colour c) {
  const auto mixed = [&](std::uint8_t part) {
    return static_cast<std::uint8_t>(std::lround(255 - (255 - part) * c.alpha / 255.0));
  };
  return {mixed(c.red), mixed(c.green), mixed(c.blue)};
}

figure::Colour colour_of(const figure::Primitive& primitive) {
  return std::visit([](const auto& one) { return one.colour; }, primitive);
}

}  // namespace

double unmatched_share(const figure::Picture& a, const figure::Picture& b) {
  if (a.width != b.width || a.height != b.height) return 1.0;
  const figure::Picture left = smoothed(a);
  const figure::Picture right = smoothed(b);
  return static_cast<double>(unmatched(left, right) + unmatched(right, left)) /
         (static_cast<double>(a.width) * a.height);
}

SampledInk sampled_ink(const figure::DrawList& list, const figure::Picture& first,
                       const figure::Picture& second) {
  constexpr int exact = 24;     // the first picture shows it here, and nothing above it
  constexpr int softened = 60;  // a thin line between two rows of pixels is paler
  SampledInk out;
  for (const figure::Primitive& primitive : list.primitives) {
    const figure::Colour colour = on_white(colour_of(primitive));
    for (const figure::PixelPoint& p : samples_of(primitive)) {
      const int x = static_cast<int>(std::floor(p.x));
      const int y = static_cast<int>(std::floor(p.y));
      if (x < 0 || y < 0 || x >= first.width || y >= first.height) continue;
      if (!alike(first.at(x, y), colour, exact)) continue;
      ++out.asked;
      out.found += has_near(second, x, y, colour, softened) ? 1 : 0;
    }
  }
  return out;
}

}  // namespace tribolog::render
