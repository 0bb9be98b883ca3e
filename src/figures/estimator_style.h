#pragma once
// One look for each estimator in every figure. Dash and marker alone already tell all of them
// apart, so that a grey print loses nothing.

#include <string>

#include "method/hysteresis/estimator.h"
#include "render/figure/figure.h"

namespace tribolog::figures {

struct SeriesStyle {
  render::figure::Colour colour;
  render::figure::LineStyle line{render::figure::LineStyle::solid};
  render::figure::Marker marker{render::figure::Marker::none};
  double width_px{2.5};
  double marker_px{9.0};
  double bin_px{14.0};  ///< Its markers where runs are angle bins of a sweep.
};

SeriesStyle estimator_style(method::hysteresis::Estimator estimator);

/// Of the curve that the candidates are held against: on the bins' markers it still leaves a ring.
inline constexpr SeriesStyle reference_style{render::figure::palette::black,
                                             render::figure::LineStyle::solid,
                                             render::figure::Marker::none,
                                             2.0,
                                             6.0,
                                             6.0};

/// Gives a series the colour, dash, marker and sizes.
void apply(const SeriesStyle& style, render::figure::Series& series);

/// "mid-line", "sweep fit", "mean of A and B", "A": the estimator in words.
std::string estimator_words(method::hysteresis::Estimator estimator);

/// The two directions of motion, in every figure that tells them apart.
inline constexpr render::figure::Colour rising_colour = render::figure::palette::blue;
inline constexpr render::figure::Colour falling_colour = render::figure::palette::vermilion;
/// The gravity peak and what follows from it; dark enough for text.
inline constexpr render::figure::Colour peak_colour{0, 105, 75};

}  // namespace tribolog::figures
