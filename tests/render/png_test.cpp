#include <cstdlib>
#include <utility>

#include <gtest/gtest.h>

#include "render/png/png_encoder.h"
#include "render/png_reading.h"

namespace tribolog::render::png_test {
namespace {

figure::Picture pattern(int width, int height, int colours) {
  figure::Picture picture{width, height, {}};
  for (int i = 0; i < width * height; ++i) {
    const int k = (i * 7 + i / width) % colours;
    picture.rgb.push_back(static_cast<std::uint8_t>(k));
    picture.rgb.push_back(static_cast<std::uint8_t>(k >> 8));
    picture.rgb.push_back(static_cast<std::uint8_t>(255 - k % 200));
  }
  return picture;
}

TEST(Png, DecodesToTheSamePixels) {
  for (const int colours : {1, 2, 200, 256, 5000}) {
    for (const auto& [width, height] : {std::pair{1, 1}, {7, 3}, {163, 98}}) {
      const figure::Picture picture = pattern(width, height, colours);
      EXPECT_EQ(read_png(png::encode_png(picture)).rgb, picture.rgb) << colours << " colours";
    }
  }
}

constexpr std::size_t colour_type = 25;

TEST(Png, UsesAPaletteUpTo256Colours) {
  EXPECT_EQ(png::encode_png(pattern(100, 100, 256))[colour_type], std::byte{3});
  EXPECT_EQ(png::encode_png(pattern(100, 100, 5000))[colour_type], std::byte{2});
}

// 256 colours near to one another or not, and half as many that stand alone.
TEST(Png, GivesColoursTooManyTheNearestOfThePalette) {
  for (const bool near : {true, false}) {
    figure::Picture picture{96, 100, {}};
    const auto put = [&](int red, int green, int blue) {
      for (const int c : {red, green, blue}) picture.rgb.push_back(static_cast<std::uint8_t>(c));
    };
    for (int i = 0; i < picture.width * picture.height; ++i) {
      const int k = i % 384;
      if (k >= 256) {
        put(255, (k % 16) * 16, (k - 256) / 16 * 32);
      } else if (near) {
        put(k, 0, 0);
      } else {
        put((k % 16) * 16, k / 16 * 16, 0);
      }
    }
    const auto bytes = png::encode_png(picture);
    const figure::Picture back = read_png(bytes);
    EXPECT_EQ(bytes[colour_type], near ? std::byte{3} : std::byte{2});
    for (std::size_t i = 0; i < back.rgb.size(); ++i) {
      EXPECT_LE(std::abs(back.rgb[i] - picture.rgb[i]), near ? png::largest_colour_error : 0);
    }
    for (std::size_t i = 0; i < back.rgb.size(); i += 3) {
      if (picture.rgb[i] != 255 || picture.rgb[i + 2] == 0) continue;
      EXPECT_EQ(back.rgb[i + 1], picture.rgb[i + 1]) << "has no near colour and stays";
    }
  }
}

// A chart's edges fade through any number of colours; its areas, and what is a pixel thin, stay.
TEST(Png, RoundsSinglePixelsWhereThatGivesAPalette) {
  figure::Picture picture{400, 40, {}};
  for (int i = 0; i < picture.width * picture.height; ++i) {
    const bool is_edge = i % 4 == 3;
    const int k = i / 4;
    for (const int c : {k % 251, k % 241, k % 239}) {
      picture.rgb.push_back(static_cast<std::uint8_t>(is_edge ? c : 200));
    }
  }
  EXPECT_EQ(png::encode_png(picture)[colour_type], std::byte{2});
  const auto bytes = png::encode_png(picture, png::SinglePixels::may_be_rounded);
  EXPECT_EQ(bytes[colour_type], std::byte{3});
  const figure::Picture back = read_png(bytes);
  for (std::size_t i = 0; i < back.rgb.size(); ++i) {
    const bool is_edge = i / 3 % 4 == 3;
    EXPECT_LE(std::abs(back.rgb[i] - picture.rgb[i]), is_edge ? 16 + png::largest_colour_error : 0);
  }
}

TEST(Png, StatesItsPrintedSize) {
  const auto bytes = png::encode_png(pattern(1600, 10, 4));
  const std::string text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  const std::size_t at = text.find("pHYs");
  ASSERT_NE(at, std::string::npos);
  EXPECT_EQ(text.substr(at + 4, 9), std::string("\0\0\x27\x10\0\0\x27\x10\x01", 9))
      << "10,000 pixels a metre";
  EXPECT_EQ(text.find("tIME"), std::string::npos);
}

}  // namespace
}  // namespace tribolog::render::png_test
