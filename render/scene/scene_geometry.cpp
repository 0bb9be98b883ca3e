#include "render/scene/scene_geometry.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/error.h"
#include "render/figure/scene.h"

namespace tribolog::render::scene {
namespace {

struct Extent {
  double left{1e300}, right{-1e300}, low{1e300}, high{-1e300};
  void add(double u, double v, double radius) {
    left = std::min(left, u - radius);
    right = std::max(right, u + radius);
    low = std::min(low, v - radius);
    high = std::max(high, v + radius);
  }
};

bool is_finite(figure::Point3 p) { return std::isfinite(figure::dot(p, p)); }

void check(const figure::SceneCamera& camera) {
  const figure::Point3 side = figure::cross(camera.towards, camera.up);
  if (!is_finite(side) ||
      figure::length(side) < 1e-6 * figure::length(camera.towards) * figure::length(camera.up) ||
      figure::length(side) == 0) {
    throw FigureError({"drawing.camera_without_direction"});
  }
  if (!(camera.opening_deg >= 0 && camera.opening_deg < 90)) {
    throw FigureError({"drawing.camera_opening", {{"opening_deg", camera.opening_deg}}});
  }
  if (!(camera.margin >= 0 && camera.margin < 0.45)) {
    throw FigureError({"drawing.scene_margin", {{"margin", camera.margin}}});
  }
}

}  // namespace

std::vector<Sphere> reach_of(const figure::Scene& scene) {
  std::vector<Sphere> all;
  for (const figure::SceneBody& body : scene.bodies) {
    all.push_back({body.from, body.from_radius_m});
    all.push_back({body.to, body.to_radius_m});
  }
  for (const figure::SceneDrum& drum : scene.drums) {
    if (figure::length(drum.axis) == 0) continue;
    const figure::Point3 half = 0.5 * drum.length_m * figure::unit(drum.axis);
    all.push_back({drum.centre + half, drum.radius_m});
    all.push_back({drum.centre - half, drum.radius_m});
  }
  for (const figure::SceneArrow& arrow : scene.arrows) {
    all.push_back({arrow.from, arrow.radius_m});
    all.push_back({arrow.to, arrow.radius_m});
  }
  for (const figure::SceneBall& ball : scene.balls) all.push_back({ball.centre, ball.radius_m});
  for (const figure::SceneSector& sector : scene.sectors) {
    if (figure::length(sector.normal) == 0 || figure::length(sector.zero) == 0) continue;
    constexpr int steps = 24;
    for (int i = 0; i <= steps; ++i) {
      const double angle = sector.from_rad + (sector.to_rad - sector.from_rad) * i / steps;
      const figure::Point3 arm =
          figure::turned(figure::unit(sector.zero), figure::unit(sector.normal), angle);
      all.push_back({sector.centre + sector.radius_m * arm, 0.0});
    }
  }
  for (const figure::SceneDimension& one : scene.dimensions) {
    for (const figure::Point3 end : {one.from, one.to}) all.push_back({end + one.shift, 0.0});
  }
  for (const figure::SceneLine& line : scene.lines) {
    for (const figure::Point3 p : line.points) all.push_back({p, 0.0});
  }
  for (const figure::SceneText& text : scene.texts) all.push_back({text.at, 0.0});
  if (scene.ground) {
    const double half = scene.ground->half_size_m;
    for (const double x : {-half, half}) {
      for (const double y : {-half, half}) {
        all.push_back({scene.ground->centre + figure::Point3{x, y, 0}, 0.0});
      }
    }
  }
  return all;
}

figure::SceneView fit_view(const figure::SceneCamera& camera, const std::vector<Sphere>& shown,
                           const figure::PixelBox& room) {
  check(camera);
  figure::SceneView view;
  view.forward = figure::unit(camera.towards);
  view.right = figure::unit(figure::cross(view.forward, camera.up));
  view.up = figure::cross(view.right, view.forward);
  figure::Point3 low = shown.front().centre;
  figure::Point3 high = low;
  for (const Sphere& one : shown) {
    const figure::Point3 p = one.centre;
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  const figure::Point3 centre = 0.5 * (low + high);
  double reach = 0;
  for (const Sphere& one : shown) {
    reach = std::max(reach, figure::length(one.centre - centre) + one.radius_m);
  }
  if (!std::isfinite(reach) || !(reach > 0)) {
    throw FigureError({"drawing.scene_without_size"});
  }
  view.parallel = camera.opening_deg == 0;
  const double opening = camera.opening_deg * std::numbers::pi / 180;
  const double away = view.parallel ? 4 * reach : reach / std::sin(opening / 2);
  view.eye = centre - away * view.forward;
  view.nearest_m = away - reach;
  view.farthest_m = away + reach;

  Extent extent;
  for (const Sphere& one : shown) {
    const figure::Point3 p = one.centre - view.eye;
    const double shrink = view.parallel ? 1.0 : 1.0 / figure::dot(p, view.forward);
    extent.add(figure::dot(p, view.right) * shrink, figure::dot(p, view.up) * shrink,
               one.radius_m * shrink);
  }
  const double width = std::max(extent.right - extent.left, 1e-9);
  const double height = std::max(extent.high - extent.low, 1e-9);
  view.scale = std::min(room.width() / width, room.height() / height);
  view.origin = {room.centre().x - view.scale * (extent.left + extent.right) / 2,
                 room.centre().y + view.scale * (extent.low + extent.high) / 2};
  return view;
}

// Which part is to be seen at each pixel.

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
