#pragma once
// The compression of PNG and PDF.

#include <cstdint>
#include <vector>

namespace tribolog::render {

/// A zlib stream. The same bytes give the same stream. @throw tribolog::FigureError without memory.
std::vector<std::uint8_t> zlib_compressed(const std::vector<std::uint8_t>& raw);

}  // namespace tribolog::render
