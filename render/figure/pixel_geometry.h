#pragma once
// Points and boxes in pixels of the picture: origin top left, y downwards.

#include <algorithm>

namespace tribolog::render {

struct PixelPoint {
  double x{};
  double y{};
  friend bool operator==(const PixelPoint&, const PixelPoint&) = default;
};

/// `left <= right` and `top <= bottom`; a box without area is empty.
struct PixelBox {
  double left{};
  double top{};
  double right{};
  double bottom{};

  [[nodiscard]] double width() const { return right - left; }
  [[nodiscard]] double height() const { return bottom - top; }
  [[nodiscard]] double area() const { return width() * height(); }
  [[nodiscard]] PixelPoint centre() const { return {(left + right) / 2, (top + bottom) / 2}; }
  [[nodiscard]] bool contains(PixelPoint p) const {
    return p.x >= left && p.x <= right && p.y >= top && p.y <= bottom;
  }
  [[nodiscard]] bool contains(const PixelBox& other) const {
    return other.left >= left && other.right <= right && other.top >= top && other.bottom <= bottom;
  }
  [[nodiscard]] PixelBox grown(double by) const {
    return {left - by, top - by, right + by, bottom + by};
  }
  [[nodiscard]] PixelBox moved(double dx, double dy) const {
    return {left + dx, top + dy, right + dx, bottom + dy};
  }
  friend bool operator==(const PixelBox&, const PixelBox&) = default;
};

/// Area that both cover; 0 if they only touch.
inline double overlap_area(const PixelBox& a, const PixelBox& b) {
  const double width = std::min(a.right, b.right) - std::max(a.left, b.left);
  const double height = std::min(a.bottom, b.bottom) - std::max(a.top, b.top);
  return width > 0 && height > 0 ? width * height : 0.0;
}

}  // namespace tribolog::render
