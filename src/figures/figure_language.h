#pragma once
// The texts of figures in another language.

#include "figures/report_figure.h"
#include "wording/language.h"

namespace tribolog::figures {

/// The same picture with every text in the language, and with no other change.
render::figure::Figure drawn_in_language(render::figure::Figure figure, wording::Language language);

/// The picture, and what a file of it says of itself: title and alternative text. What stands
/// beside the picture on a page is translated by the page.
ReportFigure as_file_in_language(ReportFigure figure, wording::Language language);

}  // namespace tribolog::figures
