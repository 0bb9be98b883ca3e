#pragma once
// Sizes and colours that all figures share. Sizes are for a picture 1600 px wide, which reads well
// 160 mm wide on paper and on a phone, and grow and shrink with the width.

#include "render/text/text_line.h"

namespace tribolog::render {

namespace ink {
inline constexpr Colour white{255, 255, 255};
inline constexpr Colour text{25, 25, 25};
inline constexpr Colour axis{60, 60, 60};
inline constexpr Colour grid{224, 224, 224};
inline constexpr Colour frame{190, 190, 190};
inline constexpr Colour backing{255, 255, 255, 215};
}  // namespace ink

struct FigureStyle {
  explicit FigureStyle(const Figure& figure);

  double unit{1.0};  ///< Pixels per pixel of the 1600 px picture.
  TextStyle tick;
  TextStyle axis_title;
  TextStyle panel_title;
  TextStyle figure_title;
  TextStyle legend;
  TextStyle label;      ///< Point labels.
  TextStyle reference;  ///< Texts of reference lines.

  double margin{};  ///< Around everything.
  double gap{};     ///< Between a text and what it belongs to.
  double tick_mark{};
  double axis_width{};
  double grid_width{};
};

}  // namespace tribolog::render
