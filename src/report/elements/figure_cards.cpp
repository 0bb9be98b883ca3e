#include "report/elements/figure_cards.h"

#include <algorithm>
#include <cstddef>

#include "figures/figure_csv.h"
#include "wording/tr.h"
#include "wording/words.h"

namespace tribolog::report::elements {

namespace {

using wording::tr;

constexpr std::size_t eager_figures = 3;

FigureCard card(const figures::ReportFigure& figure, const render::workers::DrawnFigure* drawn) {
  FigureCard made;
  made.id = figure.id;
  made.title = figure.title;
  made.paper_number = figure.paper_number.value_or(0);
  made.is_primary = figure.is_primary;
  // Only the paper's figures have numbers, where a page does not number its own.
  made.heading = figure.paper_number
                     ? tr("Figure {number}: {title}",
                          {{"number", *figure.paper_number}, {"title", figure.title}})
                     : figure.title;
  made.caption = wording::as_sentence(figure.caption);
  made.how_to_read = figure.how_to_read;
  made.alt = wording::or_dash(figure.alt);
  if (drawn == nullptr) {
    made.error = tr("It was not drawn.");
  } else if (!drawn->error.empty()) {
    made.error = wording::as_sentence(wording::words(drawn->error));
  } else if (drawn->png.empty()) {
    made.error = tr("Its picture is empty.");
  } else {
    made.png = &drawn->png;
    made.width_px = drawn->width_px;
    made.height_px = drawn->height_px;
  }
  if (drawn != nullptr) made.warnings = wording::words(drawn->warnings);
  made.csv = figure.english_csv.empty() ? figures::figure_csv(figure, figures::most_csv_rows)
                                        : figure.english_csv;
  return made;
}

}  // namespace

std::vector<FigureCard> figure_cards(const std::vector<figures::ReportFigure>& figures,
                                     const std::vector<render::workers::DrawnFigure>& drawn) {
  std::vector<FigureCard> cards;
  for (const figures::ReportFigure& figure : figures) {
    const auto picture = std::find_if(
        drawn.begin(), drawn.end(),
        [&figure](const render::workers::DrawnFigure& d) { return d.id == figure.id; });
    cards.push_back(card(figure, picture == drawn.end() ? nullptr : &*picture));
    cards.back().is_lazy = cards.size() > eager_figures;
  }
  return cards;
}

}  // namespace tribolog::report::elements
