#include "figures/estimator_style.h"

namespace tribolog::figures {
namespace {

namespace colour = render::palette;
using render::LineStyle;
using render::Marker;

struct NamedStyle {
  const char* name;
  const char* words;
  SeriesStyle style;
};

constexpr double usual_px = 2.5;

// Single points: own marker. Pair means: all dash_dot_dot, in the colour of the pair's first point.
const std::array<NamedStyle, styled_names.size()> styles{{
    {"A", "A", {colour::sky_blue, LineStyle::dash, Marker::triangle, usual_px, 11.0}},
    {"B", "B", {colour::vermilion, LineStyle::solid, Marker::square, usual_px, 9.0}},
    {"C", "C", {colour::green, LineStyle::dot, Marker::circle, usual_px, 9.0}},
    {"D", "D", {colour::purple, LineStyle::dot, Marker::diamond, usual_px, 11.0}},
    {"E", "E", {colour::orange, LineStyle::dash_dot, Marker::cross, usual_px, 10.0}},
    {"F", "F", {colour::blue, LineStyle::dash_dot, Marker::plus, usual_px, 10.0}},
    {"AB",
     "mean of A and B",
     {colour::sky_blue, LineStyle::dash_dot_dot, Marker::diamond, usual_px, 12.0}},
    {"CD",
     "mean of C and D",
     {colour::green, LineStyle::dash_dot_dot, Marker::square, usual_px, 10.0}},
    {"EF",
     "mean of E and F",
     {colour::orange, LineStyle::dash_dot_dot, Marker::triangle, usual_px, 11.0}},
    {"midline", "mid-line", {colour::blue, LineStyle::solid, Marker::circle, 6.0, 20.0}},
    {"fit", "LuGre fit", {colour::purple, LineStyle::dash, Marker::cross, usual_px, 14.0}},
    {"sweep", "sweep fit", {colour::grey, LineStyle::dash, Marker::plus, usual_px, 18.0}},
    {"runs",
     "fit of the runs",
     {colour::purple, LineStyle::dash_dot, Marker::circle, usual_px, 15.0}},
    {"stated", "stated gravity", {colour::black, LineStyle::dot, Marker::triangle, usual_px, 12.0}},
    {"reference", "reference", {colour::black, LineStyle::solid, Marker::none, 2.0, 6.0}},
}};

const NamedStyle* find(const std::string& name) {
  for (const NamedStyle& style : styles) {
    if (name == style.name) return &style;
  }
  return nullptr;
}

}  // namespace

SeriesStyle estimator_style(const std::string& name) {
  const NamedStyle* found = find(name);
  if (found == nullptr) return {colour::grey, LineStyle::dot, Marker::none, usual_px};
  return found->style;
}

void apply(const SeriesStyle& style, render::Series& series) {
  series.colour = style.colour;
  series.style = style.line;
  series.marker = style.marker;
  series.width_px = style.width_px;
  series.marker_size_px = style.marker_px;
}

std::string estimator_words(const std::string& name) {
  const NamedStyle* found = find(name);
  return found == nullptr ? name : found->words;
}

}  // namespace tribolog::figures
