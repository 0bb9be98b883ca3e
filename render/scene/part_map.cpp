#include "render/scene/part_map.h"

#include <algorithm>
#include <cmath>

namespace tribolog::render::scene {
namespace {

/// The pixels of a row, counted from its left end, in which a triangle may lie: a pixel more at
/// each side than those in which it does.
struct RowSpan {
  double from;
  double to;  ///< Below `from`: none.

  /// Leaves what `at_left + x * per_px` is not negative for.
  void keep_not_negative(double at_left, double per_px) {
    if (per_px > 0) from = std::max(from, -at_left / per_px - 1);
    if (per_px < 0) to = std::min(to, -at_left / per_px + 1);
    if (!(from <= to)) *this = {0, -1};
  }
};

}  // namespace

PartMap::PartMap(const figure::SceneGeometry& scene, int width, int height)
    : width_(width),
      height_(height),
      parts_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)),
      nearness_(parts_.size()) {
  const figure::SceneView& view = scene.view;
  std::vector<Corner> corners;
  for (std::size_t m = 0; m < scene.meshes.size(); ++m) {
    const figure::SceneMesh& mesh = scene.meshes[m];
    corners.clear();
    for (const figure::Point3& p : mesh.points) {
      const figure::PixelPoint at = view.pixel(p);
      // Both are linear over the picture of a flat triangle.
      const double distance = view.distance(p);
      corners.push_back(
          {at.x, at.y, view.parallel ? 2 * view.farthest_m - distance : 1.0 / distance});
    }
    for (const auto& [a, b, c] : mesh.triangles) {
      fill(corners[a], corners[b], corners[c], static_cast<std::uint16_t>(m + 1));
    }
  }
  nearness_ = {};
}

void PartMap::fill(const Corner& a, const Corner& b, const Corner& c, std::uint16_t part) {
  const double area = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
  if (!(std::abs(area) > 1e-12)) return;
  const auto first = [](double from, int most) {
    return static_cast<int>(std::clamp(std::ceil(from - 0.5), 0.0, static_cast<double>(most)));
  };
  const auto last = [](double to, int most) {
    return static_cast<int>(std::clamp(std::floor(to - 0.5), -1.0, most - 1.0));
  };
  const int left = first(std::min({a.x, b.x, c.x}), width_);
  const int right = last(std::max({a.x, b.x, c.x}), width_);
  const int top = first(std::min({a.y, b.y, c.y}), height_);
  const int bottom = last(std::max({a.y, b.y, c.y}), height_);
  // Shares of the corners change by these from one pixel to the next.
  const double b_per_px = (c.y - a.y) / area;
  const double c_per_px = -(b.y - a.y) / area;
  for (int y = top; y <= bottom; ++y) {
    const double py = y + 0.5;
    const double px_left = left + 0.5;
    const double b_left = ((px_left - a.x) * (c.y - a.y) - (c.x - a.x) * (py - a.y)) / area;
    const double c_left = ((b.x - a.x) * (py - a.y) - (px_left - a.x) * (b.y - a.y)) / area;
    RowSpan span{0, static_cast<double>(right - left)};
    span.keep_not_negative(b_left, b_per_px);
    span.keep_not_negative(c_left, c_per_px);
    span.keep_not_negative(1 - b_left - c_left, -b_per_px - c_per_px);
    const int end = left + static_cast<int>(std::ceil(span.to));
    for (int x = left + static_cast<int>(span.from); x <= end; ++x) {
      const double px = x + 0.5;
      const double share_b = ((px - a.x) * (c.y - a.y) - (c.x - a.x) * (py - a.y)) / area;
      const double share_c = ((b.x - a.x) * (py - a.y) - (px - a.x) * (b.y - a.y)) / area;
      if (share_b < 0 || share_c < 0 || share_b + share_c > 1) continue;
      const auto nearness = static_cast<float>(a.nearness + share_b * (b.nearness - a.nearness) +
                                               share_c * (c.nearness - a.nearness));
      const std::size_t i = static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                            static_cast<std::size_t>(x);
      if (nearness <= nearness_[i]) continue;
      nearness_[i] = nearness;
      parts_[i] = part;
    }
  }
}

bool PartMap::inside(int x, int y, int reach) const {
  if (x < reach || y < reach || x + reach >= width_ || y + reach >= height_) return false;
  const std::uint16_t part = at(x, y);
  for (const int dy : {-reach, 0, reach}) {
    for (const int dx : {-reach, 0, reach}) {
      if (at(x + dx, y + dy) != part) return false;
    }
  }
  return true;
}

}  // namespace tribolog::render::scene
