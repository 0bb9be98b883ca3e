#pragma once
// Which parts of a panel are taken, on a grid of a few pixels, to find room for texts.

#include <cstdint>
#include <vector>

#include "render/figure/draw_list.h"

namespace tribolog::render::layout {

class Occupancy {
 public:
  explicit Occupancy(const figure::PixelBox& area);

  /// Marks everything that a primitive covers; what lies outside the area is ignored.
  void mark(const figure::Primitive& primitive);
  void mark(const figure::PixelBox& box);
  void mark(figure::PixelPoint a, figure::PixelPoint b, double width);

  /// Number of taken cells that a box touches, and as a share of all it touches.
  [[nodiscard]] long taken(const figure::PixelBox& box) const;
  [[nodiscard]] double share_taken(const figure::PixelBox& box) const;

  static constexpr double cell_px = 4.0;

 private:
  struct Cells {
    int left, top, right, bottom;  // half open
    [[nodiscard]] long count() const { return static_cast<long>(right - left) * (bottom - top); }
  };
  [[nodiscard]] Cells cells_of(const figure::PixelBox& box) const;
  void sum_up() const;

  figure::PixelBox area_;
  int columns_;
  int rows_;
  std::vector<std::uint8_t> cells_;
  mutable std::vector<std::int32_t> sums_;  ///< Summed-area table, rebuilt when stale.
  mutable bool stale_{true};
};

}  // namespace tribolog::render::layout
