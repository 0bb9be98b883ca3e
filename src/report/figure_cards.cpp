// Figures and their pictures, paired by id.

#include <algorithm>

#include "figures/figure_csv.h"
#include "report/view_parts.h"

namespace tribolog::report {
namespace {

constexpr std::size_t eager_figures = 3;
constexpr std::size_t most_csv_rows = 420;  ///< About 10 kB; a report has some twenty figures.

FigureCard card(const ReportFigure& figure, const render::DrawnFigure* drawn) {
  FigureCard made;
  made.id = figure.id;
  // Only the paper's figures have numbers.
  made.heading = figure.number > 0 ? "Figure " + std::to_string(figure.number) + ": " + figure.title
                                   : figure.title;
  made.caption = as_sentence(figure.caption);
  made.how_to_read = figure.how_to_read;
  made.alt = or_dash(figure.alt);
  if (drawn == nullptr) {
    made.error = "It was not drawn.";
  } else if (!drawn->error.empty()) {
    made.error = as_sentence(drawn->error);
  } else if (drawn->png.empty()) {
    made.error = "Its picture is empty.";
  } else {
    made.png = &drawn->png;
    made.width_px = drawn->width_px;
    made.height_px = drawn->height_px;
  }
  if (drawn != nullptr) made.warnings = drawn->warnings;
  made.csv = figure_csv(figure, most_csv_rows);
  return made;
}

}  // namespace

std::vector<FigureCard> figure_cards(const std::vector<ReportFigure>& figures,
                                     const std::vector<render::DrawnFigure>& drawn) {
  std::vector<FigureCard> cards;
  for (const ReportFigure& figure : figures) {
    const auto picture =
        std::find_if(drawn.begin(), drawn.end(),
                     [&figure](const render::DrawnFigure& d) { return d.id == figure.id; });
    cards.push_back(card(figure, picture == drawn.end() ? nullptr : &*picture));
    cards.back().is_lazy = cards.size() > eager_figures;
  }
  return cards;
}

}  // namespace tribolog::report
