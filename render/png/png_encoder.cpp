#include "render/png/png_encoder.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <memory>
#include <string_view>

#include <libdeflate.h>

#include "base/error.h"

namespace tribolog::render::png {

namespace {

constexpr int compression_level = 6;

}  // namespace

std::vector<std::uint8_t> zlib_compressed(const std::vector<std::uint8_t>& raw) {
  const std::unique_ptr<libdeflate_compressor, void (*)(libdeflate_compressor*)> compressor(
      libdeflate_alloc_compressor(compression_level), libdeflate_free_compressor);
  if (!compressor) throw FigureError({"drawing.no_memory_to_compress"});
  std::vector<std::uint8_t> out(libdeflate_zlib_compress_bound(compressor.get(), raw.size()));
  out.resize(
      libdeflate_zlib_compress(compressor.get(), raw.data(), raw.size(), out.data(), out.size()));
  if (out.empty()) throw FigureError({"drawing.not_compressed"});
  return out;
}

namespace {

constexpr std::uint8_t filter_none = 0;
constexpr std::uint8_t filter_up = 2;
constexpr std::uint8_t type_rgb = 2;
constexpr std::uint8_t type_indexed = 3;

using Bytes = std::vector<std::uint8_t>;

void put_u32(Bytes& out, std::uint32_t value) {
  for (const unsigned shift : {24U, 16U, 8U, 0U}) {
    out.push_back(static_cast<std::uint8_t>(value >> shift));
  }
}

void put_chunk(Bytes& out, std::string_view name, const Bytes& data) {
  put_u32(out, static_cast<std::uint32_t>(data.size()));
  const std::size_t start = out.size();
  out.insert(out.end(), name.begin(), name.end());
  out.insert(out.end(), data.begin(), data.end());
  put_u32(out, libdeflate_crc32(0, out.data() + start, out.size() - start));
}

/// Rows with their filter byte in front.
Bytes filtered(const Bytes& pixels, std::size_t row, std::uint8_t filter) {
  const std::size_t rows = pixels.size() / row;
  Bytes out((row + 1) * rows);
  for (std::size_t y = 0; y < rows; ++y) {
    const std::uint8_t* from = pixels.data() + y * row;
    std::uint8_t* to = out.data() + y * (row + 1);
    const bool up = filter == filter_up && y > 0;
    *to++ = up ? filter_up : filter_none;
    if (!up) {
      std::memcpy(to, from, row);
    } else {
      for (std::size_t i = 0; i < row; ++i) {
        to[i] = static_cast<std::uint8_t>(
            from[i] - from[static_cast<std::ptrdiff_t>(i) - static_cast<std::ptrdiff_t>(row)]);
      }
    }
  }
  return out;
}

}  // namespace

std::vector<std::byte> encode_png(const figure::Picture& picture, SinglePixels single) {
  const auto palette = indexed(picture, single);
  Bytes out{0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
  Bytes header;
  put_u32(header, static_cast<std::uint32_t>(picture.width));
  put_u32(header, static_cast<std::uint32_t>(picture.height));
  header.insert(header.end(), {8, palette ? type_indexed : type_rgb, 0, 0, 0});
  put_chunk(out, "IHDR", header);

  Bytes density;
  const auto per_metre =
      static_cast<std::uint32_t>(std::lround(1000 * picture.width / picture.width_mm));
  put_u32(density, per_metre);
  put_u32(density, per_metre);
  density.push_back(1);  // the unit is the metre
  put_chunk(out, "pHYs", density);

  const auto width = static_cast<std::size_t>(picture.width);
  if (palette) {
    put_chunk(out, "PLTE", palette->palette);
    put_chunk(out, "IDAT", zlib_compressed(filtered(palette->indices, width, filter_none)));
  } else {
    put_chunk(out, "IDAT", zlib_compressed(filtered(picture.rgb, 3 * width, filter_up)));
  }
  put_chunk(out, "IEND", {});
  std::vector<std::byte> bytes(out.size());
  std::memcpy(bytes.data(), out.data(), out.size());
  return bytes;
}

}  // namespace tribolog::render::png
