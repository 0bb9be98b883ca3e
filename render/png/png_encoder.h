#pragma once
// Pictures to PNG.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "render/figure/picture.h"

namespace tribolog::render::png {

/// A zlib stream. The same bytes give the same stream. @throw tribolog::FigureError without memory.
std::vector<std::uint8_t> zlib_compressed(const std::vector<std::uint8_t>& raw);

/// The same picture gives the same bytes: no time stamp, no text. Indexed colour where 256 of them
/// suffice (palette.h), else exact. As wide in print as the picture says, by programs that heed
/// pHYs.
std::vector<std::byte> encode_png(const figure::Picture& picture);

}  // namespace tribolog::render::png
