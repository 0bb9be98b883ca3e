#pragma once
// A finished picture.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "render/figure.h"

namespace tribolog::render {

/// Rows from top to bottom, three bytes (red, green, blue) a pixel.
struct Picture {
  int width{};
  int height{};
  std::vector<std::uint8_t> rgb;
  double width_mm{160.0};  ///< In print.

  [[nodiscard]] Colour at(int x, int y) const {
    const std::size_t i = 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                               static_cast<std::size_t>(x));
    return {rgb[i], rgb[i + 1], rgb[i + 2]};
  }
};

}  // namespace tribolog::render
