#include "render/layout/figure_style.h"

#include <algorithm>
#include <cmath>

namespace tribolog::render {

FigureStyle::FigureStyle(const Figure& figure) {
  constexpr double designed_width = 1600.0;
  constexpr double crowded = 0.87;  // three panels and more leave less room for titles
  unit = std::clamp(figure.width_px / designed_width, 0.35, 4.0);
  const double text = unit * (figure.panels.size() >= 3 ? crowded : 1.0);
  const auto sized = [](double size, double factor, Weight weight = Weight::regular) {
    return TextStyle{std::max(8, static_cast<int>(std::lround(size * factor))), weight, ink::text};
  };
  tick = sized(26, text);
  axis_title = sized(30, text);
  panel_title = sized(28, text);
  figure_title = sized(32, unit, Weight::bold);
  legend = sized(26, text);
  label = sized(28, text, Weight::bold);
  reference = sized(25, text);
  margin = 22 * unit;
  gap = 10 * unit;
  tick_mark = 8 * unit;
  axis_width = std::max(1.0, 2.0 * unit);
  grid_width = std::max(1.0, 1.5 * unit);
}

}  // namespace tribolog::render
