#pragma once
// Colours, line styles and markers that charts, diagrams and scenes share.

#include <cstdint>

namespace tribolog::render {

struct Colour {
  std::uint8_t red{};
  std::uint8_t green{};
  std::uint8_t blue{};
  std::uint8_t alpha{255};
  friend bool operator==(const Colour&, const Colour&) = default;
};

/// Okabe and Ito's palette: distinguishable with every common colour blindness.
namespace palette {
inline constexpr Colour black{0, 0, 0};
inline constexpr Colour orange{230, 159, 0};
inline constexpr Colour sky_blue{86, 180, 233};
inline constexpr Colour green{0, 158, 115};
inline constexpr Colour yellow{240, 228, 66};
inline constexpr Colour blue{0, 114, 178};
inline constexpr Colour vermilion{213, 94, 0};
inline constexpr Colour purple{204, 121, 167};
inline constexpr Colour grey{120, 120, 120};
}  // namespace palette

enum class LineStyle { none, solid, dash, dot, dash_dot, dash_dot_dot };
enum class Marker { none, circle, square, triangle, diamond, cross, plus };

}  // namespace tribolog::render
