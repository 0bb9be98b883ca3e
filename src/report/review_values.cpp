#include <fmt/format.h>

#include "figures/plot_data.h"
#include "report/review_parts.h"
#include "wording/visible_text.h"

namespace tribolog::report::review {
namespace {

const char* name_of(render::LineStyle line) {
  switch (line) {
    case render::LineStyle::none:
      return "none";
    case render::LineStyle::dash:
      return "dash";
    case render::LineStyle::dot:
      return "dot";
    case render::LineStyle::dash_dot:
      return "dash_dot";
    case render::LineStyle::dash_dot_dot:
      return "dash_dot_dot";
    case render::LineStyle::solid:
      break;
  }
  return "solid";
}

}  // namespace

Json shown_text(const std::string& text) { return json::text_or_null(visible_text(text)); }

Json quantity(const std::string& words, const std::string& symbol, const std::string& unit) {
  return {{"words", words}, {"symbol", symbol}, {"unit", unit}};
}

Json column(const std::vector<double>& si, const figures::AxisScale& scale) {
  return json::short_numbers(figures::shown(si, scale));
}

Json entry(double si, const figures::AxisScale& scale) { return column({si}, scale).front(); }

Json style(render::Colour colour, render::LineStyle line) {
  return {{"colour", fmt::format("#{:02x}{:02x}{:02x}", colour.red, colour.green, colour.blue)},
          {"line", name_of(line)}};
}

}  // namespace tribolog::report::review
