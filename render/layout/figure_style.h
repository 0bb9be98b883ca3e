#pragma once
// Sizes and colours that all figures share. Sizes of a report are for a picture 1600 px wide, which
// reads well 160 mm wide on paper and on a phone; those of a publication are 7 to 8 pt in print.
// Both grow and shrink with the pixels per millimetre.

#include "render/text/text_line.h"

namespace tribolog::render::layout {

namespace ink {
inline constexpr figure::Colour white{255, 255, 255};
inline constexpr figure::Colour text{25, 25, 25};
inline constexpr figure::Colour axis{60, 60, 60};
inline constexpr figure::Colour grid{224, 224, 224};
inline constexpr figure::Colour frame{190, 190, 190};
inline constexpr figure::Colour backing{255, 255, 255, 215};
}  // namespace ink

struct FigureStyle {
  explicit FigureStyle(const figure::Figure& figure);

  double unit{1.0};             ///< Pixels to 0.1 mm in print: 1 in a picture 1600 px wide.
  double stroke{1.0};           ///< What widths of lines are multiplied with,
  double marker{1.0};           ///< and sizes of markers.
  double most_diagram_scale{};  ///< Of a drawing's millimetres in print.
  text::TextStyle tick;
  text::TextStyle axis_title;
  text::TextStyle panel_title;
  text::TextStyle figure_title;
  text::TextStyle legend;
  text::TextStyle label;      ///< Point labels.
  text::TextStyle reference;  ///< Texts of reference lines.

  double margin{};         ///< Around everything.
  double gap{};            ///< Between a text and what it belongs to.
  double legend_sample{};  ///< Length of a curve's piece in the legend.
  double tick_mark{};
  double axis_width{};
  double grid_width{};
};

}  // namespace tribolog::render::layout
