#pragma once
// The texts of figures in another language.

#include "figures/report_figure.h"
#include "wording/language.h"

namespace tribolog {

/// The same picture with every text in the language, and with no other change.
render::Figure drawn_in_language(render::Figure figure, Language language);

/// The picture, and what a file of it says of itself: title and alternative text. What stands
/// beside the picture on a page is translated by the page.
ReportFigure as_file_in_language(ReportFigure figure, Language language);

}  // namespace tribolog
