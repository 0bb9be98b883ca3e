#pragma once
// Figures drawn with progress, those that failed named, and the pages that have some.

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "calibration/provenance.h"
#include "cli/archive_commands.h"
#include "cli/console.h"
#include "figures/report_figure.h"
#include "render/workers/renderer.h"
#include "report/document/report_view.h"
#include "tribolog/figures.h"
#include "wording/language.h"

namespace tribolog::cli {

/// Pictures in the order of the figures. A graphics stack that
/// cannot start at all leaves every picture with its error.
std::vector<render::workers::DrawnFigure> draw(render::workers::FigureRenderer& renderer,
                                               const std::vector<figures::ReportFigure>& figures,
                                               Console& console);

/// Warns of each figure that failed; returns how many did.
std::size_t tell_failures(const std::vector<FigureOutcome>& figures, Console& console);
std::size_t tell_failures(const std::vector<render::workers::DrawnFigure>& drawn, Console& console);

// What `archive diff` and `archive trend` have in common: text from tables, and a page with
// figures.

/// Characters of a note that are printed at most.
inline constexpr std::size_t longest_note = 1000;

/// The table in aligned columns, safe for a terminal.
std::string text_of(const report::elements::Table& table);

struct PageOutput {
  std::string path;
  int processes{2};
  wording::Language language;  ///< Of the pictures.
};

/// Draws, makes the page of it, and writes that.
/// @return figure_failed where one could not be drawn; the page is written all the same.
ExitStatus write_history_page(
    const PageOutput& output, const std::vector<figures::ReportFigure>& figures,
    const Invocation& call,
    const std::function<std::string(const calibration::Provenance&,
                                    const std::vector<render::workers::DrawnFigure>&)>& make_page);

}  // namespace tribolog::cli
