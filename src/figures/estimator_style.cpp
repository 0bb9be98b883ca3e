#include "figures/estimator_style.h"

#include "wording/tr.h"

namespace tribolog::figures {
namespace {

namespace colour = render::figure::palette;
using render::figure::LineStyle;
using render::figure::Marker;

struct NamedStyle {
  const char* name;
  const char* words;
  SeriesStyle style;
};

constexpr double usual_px = 2.5;

// Single points: own marker. Pair means: all dash_dot_dot, in the colour of the pair's first point.
const std::array<NamedStyle, styled_names.size()> styles{{
    {"A",
     "A",
     {colour::sky_blue, render::figure::LineStyle::dash, render::figure::Marker::triangle, usual_px,
      11.0}},
    {"B",
     "B",
     {colour::vermilion, render::figure::LineStyle::solid, render::figure::Marker::square, usual_px,
      9.0}},
    {"C",
     "C",
     {colour::green, render::figure::LineStyle::dot, render::figure::Marker::circle, usual_px,
      9.0}},
    {"D",
     "D",
     {colour::purple, render::figure::LineStyle::dot, render::figure::Marker::diamond, usual_px,
      11.0}},
    {"E",
     "E",
     {colour::orange, render::figure::LineStyle::dash_dot, render::figure::Marker::cross, usual_px,
      10.0}},
    {"F",
     "F",
     {colour::blue, render::figure::LineStyle::dash_dot, render::figure::Marker::plus, usual_px,
      10.0}},
    {"AB",
     wording::to_translate("mean of A and B"),
     {colour::sky_blue, render::figure::LineStyle::dash_dot_dot, render::figure::Marker::diamond,
      usual_px, 12.0}},
    {"CD",
     wording::to_translate("mean of C and D"),
     {colour::green, render::figure::LineStyle::dash_dot_dot, render::figure::Marker::square,
      usual_px, 10.0}},
    {"EF",
     wording::to_translate("mean of E and F"),
     {colour::orange, render::figure::LineStyle::dash_dot_dot, render::figure::Marker::triangle,
      usual_px, 11.0}},
    {"midline",
     wording::to_translate("mid-line"),
     {colour::blue, render::figure::LineStyle::solid, render::figure::Marker::circle, 6.0, 20.0}},
    {"fit",
     wording::to_translate("LuGre fit"),
     {colour::purple, render::figure::LineStyle::dash, render::figure::Marker::cross, usual_px,
      14.0}},
    {"sweep",
     wording::to_translate("sweep fit"),
     {colour::grey, render::figure::LineStyle::dash, render::figure::Marker::plus, usual_px, 18.0}},
    {"runs",
     wording::to_translate("fit of the runs"),
     {colour::purple, render::figure::LineStyle::dash_dot, render::figure::Marker::circle, usual_px,
      15.0}},
    {"stated",
     wording::to_translate("stated gravity"),
     {colour::black, render::figure::LineStyle::dot, render::figure::Marker::triangle, usual_px,
      12.0}},
    {"reference",
     wording::to_translate("reference"),
     {colour::black, render::figure::LineStyle::solid, render::figure::Marker::none, 2.0, 6.0}},
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
  if (found == nullptr)
    return {colour::grey, render::figure::LineStyle::dot, render::figure::Marker::none, usual_px};
  return found->style;
}

void apply(const SeriesStyle& style, render::figure::Series& series) {
  series.colour = style.colour;
  series.style = style.line;
  series.marker = style.marker;
  series.width_px = style.width_px;
  series.marker_size_px = style.marker_px;
}

std::string estimator_words(const std::string& name) {
  const NamedStyle* found = find(name);
  return found == nullptr ? name : wording::tr(found->words);
}

}  // namespace tribolog::figures
