#pragma once
// One look for each estimator in every figure. Dash and marker alone already tell all of them
// apart, so that a grey print loses nothing.

#include <array>
#include <string>

#include "render/figure/figure.h"

namespace tribolog::figures {

struct SeriesStyle {
  render::figure::Colour colour;
  render::figure::LineStyle line{render::figure::LineStyle::solid};
  render::figure::Marker marker{render::figure::Marker::none};
  double width_px{2.5};
  double marker_px{9.0};
};

/// Every name that `estimator_style` knows, in the order of the surrogate masses; last the
/// reference curve.
inline constexpr std::array<const char*, 15> styled_names{
    "A",  "B",       "C",   "D",     "E",    "F",      "AB",       "CD",
    "EF", "midline", "fit", "sweep", "runs", "stated", "reference"};

/// Grey dots for a name it does not know.
SeriesStyle estimator_style(const std::string& name);

/// Gives a series the estimator's colour, dash, marker and sizes.
void apply(const SeriesStyle& style, render::figure::Series& series);

/// "mid-line", "sweep fit", "mean of A and B", "A": the estimator in words.
std::string estimator_words(const std::string& name);

/// The two directions of motion, in every figure that tells them apart.
inline constexpr render::figure::Colour rising_colour = render::figure::palette::blue;
inline constexpr render::figure::Colour falling_colour = render::figure::palette::vermilion;
/// The gravity peak and what follows from it; dark enough for text.
inline constexpr render::figure::Colour peak_colour{0, 105, 75};

}  // namespace tribolog::figures
