#pragma once
// A picture in few colours.

#include <cstdint>
#include <optional>
#include <vector>

#include "render/figure/picture.h"

namespace tribolog::render::png {

struct IndexedPicture {
  std::vector<std::uint8_t> palette;  ///< Three bytes a colour, at most 256 colours.
  std::vector<std::uint8_t> indices;  ///< One a pixel.
};

/// How far a channel of a replaced colour may be off, of 255.
inline constexpr int largest_colour_error = 8;

/// Exact where the picture has at most 256 colours. A chart has some more, mixed at the edges of
/// lines and letters: those that differ least from another one take its place. Nothing if one would
/// be off by more than largest_colour_error, or if there are more than 1024 colours.
std::optional<IndexedPicture> indexed(const figure::Picture& picture);

}  // namespace tribolog::render::png
