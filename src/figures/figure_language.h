#pragma once
// The texts inside pictures in another language.

#include <vector>

#include "language/language.h"

#include "figures/report_figure.h"

namespace tribolog {

/// The same figures with every text that is drawn, and with no other change: what stands beside
/// the picture is translated by the page.
std::vector<ReportFigure> drawn_in_language(std::vector<ReportFigure> figures, Language language);

}  // namespace tribolog
