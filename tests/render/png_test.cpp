#include <gtest/gtest.h>

#include "png_reading.h"

#include "render/png/png_encoder.h"

namespace tribolog::render {
namespace {

Picture pattern(int width, int height, int colours) {
  Picture picture{width, height, {}};
  for (int i = 0; i < width * height; ++i) {
    const int k = (i * 7 + i / width) % colours;
    picture.rgb.push_back(static_cast<std::uint8_t>(k));
    picture.rgb.push_back(static_cast<std::uint8_t>(k >> 8));
    picture.rgb.push_back(static_cast<std::uint8_t>(255 - k % 200));
  }
  return picture;
}

TEST(Png, DecodesToTheSamePixels) {
  for (const int colours : {1, 2, 200, 256, 257, 5000}) {
    for (const auto& [width, height] : {std::pair{1, 1}, {7, 3}, {163, 98}}) {
      const Picture picture = pattern(width, height, colours);
      EXPECT_EQ(read_png(encode_png(picture)).rgb, picture.rgb) << colours << " colours";
    }
  }
}

TEST(Png, UsesAPaletteUpTo256Colours) {
  constexpr std::size_t colour_type = 25;
  EXPECT_EQ(encode_png(pattern(100, 100, 256))[colour_type], std::byte{3});
  EXPECT_EQ(encode_png(pattern(100, 100, 257))[colour_type], std::byte{2});
}

TEST(Png, StatesItsPrintedSize) {
  const auto bytes = encode_png(pattern(1600, 10, 4));
  const std::string text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  const std::size_t at = text.find("pHYs");
  ASSERT_NE(at, std::string::npos);
  EXPECT_EQ(text.substr(at + 4, 9), std::string("\0\0\x27\x10\0\0\x27\x10\x01", 9))
      << "10,000 pixels a metre";
  EXPECT_EQ(text.find("tIME"), std::string::npos);
}

}  // namespace
}  // namespace tribolog::render
