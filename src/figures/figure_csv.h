#pragma once
// The data behind a figure, as text to compute with.

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "figures/report_figure.h"
#include "wording/language.h"

namespace tribolog::figures {

/// Rows `panel,what,name,x,y,low,high` in the units of the figure's axes, which comment lines (#)
/// above the header state, with the axes whose scale is logarithmic. `what` is curve, marks (a
/// series that no line joins), interval, point, line or name (of a place on an axis); what does not
/// apply is empty. Six significant digits, lines end with LF.
/// Where a curve breaks, one row has neither x nor y, however many samples are missing there.
///
/// @param most_rows curves with more samples are thinned so that all have about as many rows in
///        sum: of every block the lowest and the highest sample stay, and a comment says so.
/// @return empty for a figure without panels: diagrams and drawings show no data.
std::string figure_csv(const ReportFigure& figure, std::size_t most_rows);

inline constexpr std::size_t most_csv_rows = 420;  ///< About 10 kB; a report has some twenty.

/// What `make` makes, in a language. The data of a figure are the same in every language: those of
/// the same figures in English.
std::vector<ReportFigure> figures_in(const wording::Language& language,
                                     const std::function<std::vector<ReportFigure>()>& make);

/// Gives each figure the data of the one with its id.
void take_english_data(const std::vector<ReportFigure>& english,
                       std::vector<ReportFigure>& figures);

}  // namespace tribolog::figures
