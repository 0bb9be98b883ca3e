#include "api/drawing.h"

#include <algorithm>

#include "base/error.h"
#include "report/document/html_report.h"
#include "wording/words.h"

namespace tribolog::api {

std::vector<render::workers::DrawnFigure> draw(render::workers::FigureRenderer& renderer,
                                               const std::vector<figures::ReportFigure>& figures,
                                               const DrawingProgress& progress) {
  std::vector<render::figure::Figure> descriptions;
  descriptions.reserve(figures.size());
  for (const figures::ReportFigure& figure : figures) {
    descriptions.push_back(figure.figure);
  }
  render::workers::DrawOptions options;
  options.progress = progress;
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
  return report::document::drawing_software(first->drawn_by);
}

std::vector<FigureOutcome> outcomes_of(const std::vector<render::workers::DrawnFigure>& drawn) {
  std::vector<FigureOutcome> outcomes;
  outcomes.reserve(drawn.size());
  for (const render::workers::DrawnFigure& one : drawn) {
    outcomes.push_back({one.id, wording::words(one.warnings), wording::words(one.error)});
  }
  return outcomes;
}

}  // namespace tribolog::api
