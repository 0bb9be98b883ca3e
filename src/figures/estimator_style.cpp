#include "figures/estimator_style.h"

#include "wording/tr.h"

namespace tribolog::figures {
namespace {

namespace colour = render::figure::palette;
using method::hysteresis::Estimator;
using render::figure::LineStyle;
using render::figure::Marker;

struct StyleInWords {
  const char* words;
  SeriesStyle style;
};

constexpr double usual_px = 2.5;

// Single points: own marker. Pair means: all dash_dot_dot, in the colour of the pair's first point.
StyleInWords style_in_words(Estimator estimator) {
  switch (estimator) {
    case Estimator::A:
      return {"A", {colour::sky_blue, LineStyle::dash, Marker::triangle, usual_px, 11.0}};
    case Estimator::B:
      return {"B", {colour::vermilion, LineStyle::solid, Marker::square, usual_px, 9.0}};
    case Estimator::C:
      return {"C", {colour::green, LineStyle::dot, Marker::circle, usual_px, 9.0}};
    case Estimator::D:
      return {"D", {colour::purple, LineStyle::dot, Marker::diamond, usual_px, 11.0}};
    case Estimator::E:
      return {"E", {colour::orange, LineStyle::dash_dot, Marker::cross, usual_px, 10.0}};
    case Estimator::F:
      return {"F", {colour::blue, LineStyle::dash_dot, Marker::plus, usual_px, 10.0}};
    case Estimator::AB:
      return {wording::to_translate("mean of A and B"),
              {colour::sky_blue, LineStyle::dash_dot_dot, Marker::diamond, usual_px, 12.0}};
    case Estimator::CD:
      return {wording::to_translate("mean of C and D"),
              {colour::green, LineStyle::dash_dot_dot, Marker::square, usual_px, 10.0}};
    case Estimator::EF:
      return {wording::to_translate("mean of E and F"),
              {colour::orange, LineStyle::dash_dot_dot, Marker::triangle, usual_px, 11.0}};
    case Estimator::midline:
      return {wording::to_translate("mid-line"),
              {colour::blue, LineStyle::solid, Marker::circle, 6.0, 20.0}};
    case Estimator::fit:
      return {wording::to_translate("LuGre fit"),
              {colour::purple, LineStyle::dash, Marker::cross, usual_px, 14.0}};
    case Estimator::sweep:
      return {wording::to_translate("sweep fit"),
              {colour::grey, LineStyle::dash, Marker::plus, usual_px, 18.0}};
    case Estimator::model:
      return {wording::to_translate("model of sweeps and runs"),
              {colour::black, LineStyle::dash_dot, Marker::circle, usual_px, 15.0}};
    case Estimator::stated:
      return {wording::to_translate("stated gravity"),
              {colour::black, LineStyle::dot, Marker::triangle, usual_px, 12.0}};
  }
  return {"", {colour::grey, LineStyle::dot, Marker::none, usual_px}};
}

}  // namespace

SeriesStyle estimator_style(Estimator estimator) { return style_in_words(estimator).style; }

void apply(const SeriesStyle& style, render::figure::Series& series) {
  series.colour = style.colour;
  series.style = style.line;
  series.marker = style.marker;
  series.width_px = style.width_px;
  series.marker_size_px = style.marker_px;
}

std::string estimator_words(Estimator estimator) {
  return wording::tr(style_in_words(estimator).words);
}

}  // namespace tribolog::figures
