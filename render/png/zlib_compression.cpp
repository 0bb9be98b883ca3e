#include "render/png/zlib_compression.h"

#include <memory>

#include <libdeflate.h>

#include "base/error.h"

namespace tribolog::render {
namespace {

constexpr int compression_level = 6;

}  // namespace

std::vector<std::uint8_t> zlib_compressed(const std::vector<std::uint8_t>& raw) {
  const std::unique_ptr<libdeflate_compressor, void (*)(libdeflate_compressor*)> compressor(
      libdeflate_alloc_compressor(compression_level), libdeflate_free_compressor);
  if (!compressor) throw FigureError("no memory for compressing a picture");
  std::vector<std::uint8_t> out(libdeflate_zlib_compress_bound(compressor.get(), raw.size()));
  out.resize(
      libdeflate_zlib_compress(compressor.get(), raw.data(), raw.size(), out.data(), out.size()));
  if (out.empty()) throw FigureError("a picture could not be compressed");
  return out;
}

}  // namespace tribolog::render
