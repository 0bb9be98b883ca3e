#pragma once
// A finished picture, and who drew it.

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "render/figure/figure.h"

namespace tribolog::render::figure {

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

/// Of a graphics stack.
struct RendererInfo {
  std::string vtk_version;  ///< "9.1.0"
  std::string back_end;     ///< "OSMesa" or "EGL"
  std::string gl_version;   ///< As the driver states it, with Mesa's version.
  std::string gl_renderer;  ///< "llvmpipe (LLVM 15.0.6, 256 bits)"
  std::string font;         ///< Font file in use.
  std::string freetype_version;
};

}  // namespace tribolog::render::figure
