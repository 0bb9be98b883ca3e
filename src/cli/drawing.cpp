#include "cli/drawing.h"

#include <algorithm>

#include <fmt/format.h>

#include "base/error.h"
#include "report/html_report.h"
#include "wording/words.h"

namespace tribolog::cli {

std::vector<render::workers::DrawnFigure> draw(render::workers::FigureRenderer& renderer,
                                               const std::vector<figures::ReportFigure>& figures,
                                               Console& console) {
  std::vector<render::figure::Figure> descriptions;
  descriptions.reserve(figures.size());
  for (const figures::ReportFigure& figure : figures) {
    descriptions.push_back(figure.figure);
  }
  render::workers::DrawOptions options;
  options.progress = [&](std::size_t done, std::size_t all) {
    console.progress("drawing figures", done, all);
  };
  try {
    return renderer.draw(descriptions, options);
  } catch (const FigureError& error) {  // of all of them
    std::vector<render::workers::DrawnFigure> missing(figures.size());
    for (std::size_t k = 0; k < figures.size(); ++k) {
      missing[k].id = figures[k].figure.id;
      missing[k].width_px = figures[k].figure.width_px;
      missing[k].height_px = figures[k].figure.height_px;
      missing[k].error = error.statement();
    }
    return missing;
  }
}

std::optional<calibration::DrawingSoftware> software_that_drew(
    const std::vector<render::workers::DrawnFigure>& drawn) {
  const auto first =
      std::find_if(drawn.begin(), drawn.end(),
                   [](const render::workers::DrawnFigure& f) { return f.error.empty(); });
  if (first == drawn.end()) return std::nullopt;
  return report::drawing_software(first->drawn_by);
}

std::size_t tell_failures(const std::vector<render::workers::DrawnFigure>& drawn,
                          Console& console) {
  std::size_t failures = 0;
  Statement last;
  for (const render::workers::DrawnFigure& figure : drawn) {
    for (const Statement& warning : figure.warnings) {
      console.warn(fmt::format("{}: note: {}", figure.id, wording::words(warning)));
    }
    if (figure.error.empty()) continue;
    ++failures;
    if (figure.error != last) {
      console.warn(fmt::format("{}: {}", figure.id, wording::words(figure.error)));
    }
    last = figure.error;
  }
  if (failures > 0) {
    console.warn(fmt::format("error: {} of {} figures could not be drawn; the numbers are kept",
                             failures, drawn.size()));
  }
  return failures;
}

}  // namespace tribolog::cli
