#pragma once
// Reads a PNG with libpng, which shares nothing with our writer.

#include <cstddef>
#include <stdexcept>
#include <vector>

#include <png.h>

#include "render/figure/picture.h"

namespace tribolog::render {

inline figure::Picture read_png(const std::vector<std::byte>& bytes) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_memory(&image, bytes.data(), bytes.size()) == 0) {
    throw std::runtime_error(image.message);
  }
  image.format = PNG_FORMAT_RGB;
  figure::Picture picture{static_cast<int>(image.width), static_cast<int>(image.height), {}};
  picture.rgb.resize(PNG_IMAGE_SIZE(image));
  if (png_image_finish_read(&image, nullptr, picture.rgb.data(), 0, nullptr) == 0) {
    throw std::runtime_error(image.message);
  }
  return picture;
}

}  // namespace tribolog::render
