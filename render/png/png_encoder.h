#pragma once
// Pictures to PNG.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "render/figure/picture.h"

namespace tribolog::render::png {

/// A zlib stream. The same bytes give the same stream. @throw tribolog::FigureError without memory.
std::vector<std::uint8_t> zlib_compressed(const std::vector<std::uint8_t>& raw);

/// What may become of pixels that differ from both neighbours in their row: of a chart they are
/// fading edges of lines and letters, of a lit body they are its shading.
enum class SinglePixels { stay, may_be_rounded };

/// The same picture gives the same bytes: no time stamp, no text. Indexed colour where 256 of them
/// suffice (see indexed()), else exact. As wide in print as the picture says, by programs that heed
/// pHYs.
std::vector<std::byte> encode_png(const figure::Picture& picture,
                                  SinglePixels single = SinglePixels::stay);

// A picture in few colours.

struct IndexedPicture {
  std::vector<std::uint8_t> palette;  ///< Three bytes a colour, at most 256 colours.
  std::vector<std::uint8_t> indices;  ///< One a pixel.
};

/// How far a channel of a replaced colour may be off, of 255.
inline constexpr int largest_colour_error = 8;

/// Exact where the picture has at most 256 colours. A chart has some more, mixed at the edges of
/// lines and letters: those that differ least from another one take its place. Nothing if one would
/// be off by more than largest_colour_error, or if there are more than 1024 colours, where single
/// pixels may be rounded even if each has one of 9 levels a channel.
std::optional<IndexedPicture> indexed(const figure::Picture& picture, SinglePixels single);

}  // namespace tribolog::render::png
