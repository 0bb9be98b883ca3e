#include "render/layout/occupancy.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace tribolog::render::layout {
namespace {

template <typename... Parts>
struct Overloaded : Parts... {
  using Parts::operator()...;
};
template <typename... Parts>
Overloaded(Parts...) -> Overloaded<Parts...>;

}  // namespace

Occupancy::Occupancy(const figure::PixelBox& area)
    : area_(area),
      columns_(std::max(1, static_cast<int>(std::ceil(area.width() / cell_px)))),
      rows_(std::max(1, static_cast<int>(std::ceil(area.height() / cell_px)))),
      cells_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_)) {}

Occupancy::Cells Occupancy::cells_of(const figure::PixelBox& box) const {
  const auto cell = [](double distance, int most, bool upper) {
    const double at = distance / cell_px;
    return static_cast<int>(
        std::clamp(upper ? std::ceil(at) : std::floor(at), 0.0, static_cast<double>(most)));
  };
  return {cell(box.left - area_.left, columns_, false), cell(box.top - area_.top, rows_, false),
          cell(box.right - area_.left, columns_, true), cell(box.bottom - area_.top, rows_, true)};
}

void Occupancy::mark(const figure::PixelBox& box) {
  const Cells cells = cells_of(box);
  for (int row = cells.top; row < cells.bottom; ++row) {
    const auto start = cells_.begin() + static_cast<std::ptrdiff_t>(row) * columns_;
    if (cells.left < cells.right) std::fill(start + cells.left, start + cells.right, 1);
  }
  stale_ = true;
}

void Occupancy::mark(figure::PixelPoint a, figure::PixelPoint b, double width) {
  const double length = std::hypot(b.x - a.x, b.y - a.y);
  const int steps = std::max(1, static_cast<int>(std::ceil(length / cell_px)));
  const double half = width / 2;
  for (int i = 0; i <= steps; ++i) {
    const double t = static_cast<double>(i) / steps;
    const double x = a.x + t * (b.x - a.x);
    const double y = a.y + t * (b.y - a.y);
    mark(figure::PixelBox{x - half, y - half, x + half, y + half});
  }
}

void Occupancy::mark(const figure::Primitive& primitive) {
  std::visit(
      Overloaded{[&](const figure::Polyline& line) {
                   for (std::size_t i = 1; i < line.points.size(); ++i) {
                     mark(line.points[i - 1], line.points[i], line.width);
                   }
                 },
                 [&](const figure::Ribbon& ribbon) {
                   for (std::size_t i = 1; i < ribbon.edge_a.size(); ++i) {
                     const auto& [a0, a1] = std::pair(ribbon.edge_a[i - 1], ribbon.edge_a[i]);
                     const auto& [b0, b1] = std::pair(ribbon.edge_b[i - 1], ribbon.edge_b[i]);
                     mark(figure::PixelBox{std::min(a0.x, a1.x), std::min({a0.y, a1.y, b0.y, b1.y}),
                                           std::max(a0.x, a1.x),
                                           std::max({a0.y, a1.y, b0.y, b1.y})});
                   }
                 },
                 [&](const figure::Polygon& polygon) {
                   figure::PixelBox box{1e9, 1e9, -1e9, -1e9};
                   for (const figure::PixelPoint& p : polygon.outline) {
                     box = {std::min(box.left, p.x), std::min(box.top, p.y),
                            std::max(box.right, p.x), std::max(box.bottom, p.y)};
                   }
                   mark(box);
                 },
                 [&](const figure::Markers& markers) {
                   const double half = markers.size / 2;
                   for (const figure::PixelPoint& c : markers.centres) {
                     mark(figure::PixelBox{c.x - half, c.y - half, c.x + half, c.y + half});
                   }
                 },
                 [&](const figure::TextRun& run) { mark(run.box); }},
      primitive);
}

void Occupancy::sum_up() const {
  const auto width = static_cast<std::size_t>(columns_) + 1;
  sums_.assign(width * (static_cast<std::size_t>(rows_) + 1), 0);
  for (std::size_t row = 0; row < static_cast<std::size_t>(rows_); ++row) {
    std::int32_t along = 0;
    for (std::size_t column = 0; column + 1 < width; ++column) {
      along += cells_[row * (width - 1) + column];
      sums_[(row + 1) * width + column + 1] = sums_[row * width + column + 1] + along;
    }
  }
  stale_ = false;
}

long Occupancy::taken(const figure::PixelBox& box) const {
  if (stale_) sum_up();
  const Cells cells = cells_of(box);
  if (cells.left >= cells.right || cells.top >= cells.bottom) return 0;
  const auto at = [&](int row, int column) {
    return static_cast<long>(
        sums_[static_cast<std::size_t>(row) * (static_cast<std::size_t>(columns_) + 1) +
              static_cast<std::size_t>(column)]);
  };
  return at(cells.bottom, cells.right) - at(cells.top, cells.right) - at(cells.bottom, cells.left) +
         at(cells.top, cells.left);
}

double Occupancy::share_taken(const figure::PixelBox& box) const {
  const long all = cells_of(box).count();
  return all > 0 ? static_cast<double>(taken(box)) / static_cast<double>(all) : 0.0;
}

}  // namespace tribolog::render::layout
