#include "cli/drawing.h"

#include <string>

#include <fmt/format.h>

#include "api/drawing.h"

namespace tribolog::cli {

std::vector<render::workers::DrawnFigure> draw(render::workers::FigureRenderer& renderer,
                                               const std::vector<figures::ReportFigure>& figures,
                                               Console& console) {
  return api::draw(renderer, figures, [&](std::size_t done, std::size_t all) {
    console.progress("drawing figures", done, all);
  });
}

std::size_t tell_failures(const std::vector<render::workers::DrawnFigure>& drawn,
                          Console& console) {
  return tell_failures(api::outcomes_of(drawn), console);
}

std::size_t tell_failures(const std::vector<FigureOutcome>& figures, Console& console) {
  std::size_t failures = 0;
  std::string last;
  for (const FigureOutcome& figure : figures) {
    for (const std::string& warning : figure.warnings) {
      console.warn(fmt::format("{}: note: {}", figure.id, warning));
    }
    if (figure.error.empty()) continue;
    ++failures;
    if (figure.error != last) {
      console.warn(fmt::format("{}: {}", figure.id, figure.error));
    }
    last = figure.error;
  }
  if (failures > 0) {
    console.warn(fmt::format("error: {} of {} figures could not be drawn; the numbers are kept",
                             failures, figures.size()));
  }
  return failures;
}

}  // namespace tribolog::cli
