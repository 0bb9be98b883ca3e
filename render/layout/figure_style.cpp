#include "render/layout/figure_style.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tribolog::render::layout {

FigureStyle::FigureStyle(const figure::Figure& figure) {
  constexpr double designed_px_per_mm = 10.0;
  constexpr double crowded = 0.87;  // three panels and more leave less room for titles
  // In publications:
  constexpr double thinner = 0.7;
  constexpr double smaller = 0.75;
  constexpr double letters_of_a_chart = 0.92;
  const bool printed = figure.look == figure::Look::publication;
  unit = std::clamp(figure.width_px / (designed_px_per_mm * figure.width_mm), 0.35, 4.0);
  stroke = printed ? thinner * unit : unit;
  marker = printed ? smaller * unit : unit;
  most_diagram_scale = printed ? letters_of_a_chart : std::numeric_limits<double>::infinity();
  const double text = unit * (figure.panels.size() >= 3 && !printed ? crowded : 1.0);
  const auto sized = [](double size, double factor, text::Weight weight = text::Weight::regular) {
    return text::TextStyle{std::max(8, static_cast<int>(std::lround(size * factor))), weight,
                           ink::text};
  };
  // In tenths of a millimetre; 26 of them are 7.4 pt.
  tick = sized(printed ? 25 : 26, text);
  axis_title = sized(printed ? 27 : 30, text);
  panel_title = sized(printed ? 26 : 28, text);
  figure_title = sized(32, unit, text::Weight::bold);
  legend = sized(printed ? 25 : 26, text);
  label = sized(printed ? 26 : 28, text, text::Weight::bold);
  reference = sized(25, text);
  margin = (printed ? 8 : 22) * unit;
  gap = (printed ? 7 : 10) * unit;
  legend_sample = (printed ? 60 : 96) * unit;
  tick_mark = (printed ? 6 : 8) * unit;
  axis_width = std::max(1.0, 2.0 * stroke);
  grid_width = std::max(1.0, 1.5 * stroke);
}

}  // namespace tribolog::render::layout
