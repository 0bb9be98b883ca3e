#include "render/vector/pdf_picture.h"

#include <cstdint>
#include <cstring>
#include <string_view>

#include <fmt/format.h>

#include "base/error.h"
#include "render/vector/true_type_file.h"

namespace tribolog::render {
namespace {

struct PngParts {
  std::uint32_t width{};
  std::uint32_t height{};
  bool indexed{};
  std::string palette;
  std::string pixels;
};

PngParts parts_of(std::string_view png) {
  constexpr std::size_t signature = 8;
  constexpr std::uint8_t indexed = 3;
  PngParts parts;
  for (std::size_t at = signature; at + 12 <= png.size();) {
    const std::size_t size = u32_at(png, at);
    if (size > png.size() - at - 12) break;
    const std::string_view name = png.substr(at + 4, 4);
    const std::string_view data = png.substr(at + 8, size);
    if (name == "IHDR") {
      parts.width = u32_at(data, 0);
      parts.height = u32_at(data, 4);
      parts.indexed = data.size() > 9 && static_cast<std::uint8_t>(data[9]) == indexed;
    } else if (name == "PLTE") {
      parts.palette = data;
    } else if (name == "IDAT") {
      parts.pixels += data;
    }
    at += size + 12;
  }
  if (parts.width == 0 || parts.pixels.empty()) {
    throw FigureError("the picture of a scene's solid parts is damaged");
  }
  return parts;
}

std::string hexadecimal(const std::string& bytes) {
  std::string out;
  for (const char c : bytes) out += fmt::format("{:02X}", static_cast<std::uint8_t>(c));
  return out;
}

}  // namespace

int add_picture(PdfFile& file, const std::vector<std::byte>& png) {
  const PngParts parts = parts_of({reinterpret_cast<const char*>(png.data()), png.size()});
  const std::string colours =
      parts.indexed ? fmt::format("[/Indexed /DeviceRGB {} <{}>]", parts.palette.size() / 3 - 1,
                                  hexadecimal(parts.palette))
                    : "/DeviceRGB";
  constexpr int filters_of_png = 15;
  return file.add_compressed(
      parts.pixels,
      fmt::format("/Type /XObject /Subtype /Image /Width {} /Height {} /BitsPerComponent 8 "
                  "/ColorSpace {} /DecodeParms << /Predictor {} /Colors {} /BitsPerComponent 8 "
                  "/Columns {} >>",
                  parts.width, parts.height, colours, filters_of_png, parts.indexed ? 1 : 3,
                  parts.width));
}

}  // namespace tribolog::render
