#pragma once
// Colours, line styles and markers that charts, diagrams and scenes share, and how well colours
// stand out from their ground.

#include <cstdint>

namespace tribolog::render::figure {

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

// How well colours stand out from their ground, as the Web Content Accessibility Guidelines
// measure it.

inline constexpr double least_text_contrast = 4.5;  ///< WCAG 2.1, 1.4.3.
inline constexpr double least_line_contrast = 3.0;  ///< WCAG 2.1, 1.4.11.

/// (L1 + 0.05) / (L2 + 0.05) of the relative luminances, the lighter one first: 1 to 21. Both
/// opaque.
double contrast_ratio(Colour a, Colour b);

/// The colour, darkened as far as letters in it need to be read on white paper.
Colour readable_on_paper(Colour colour);

}  // namespace tribolog::render::figure
