#pragma once
// The paper regenerated, as one HTML file that needs nothing else.

#include <string>
#include <vector>

#include "calibration/calibration.h"
#include "calibration/provenance.h"
#include "figures/report_figure.h"
#include "paper/charts/paper_charts.h"
#include "paper/checks/paper_items.h"
#include "render/workers/renderer.h"
#include "wording/language.h"

namespace tribolog::paper::page {

/// A file that the page was computed from.
struct PaperSource {
  std::string name;  ///< "examples/paper/scenario.toml"
  std::string text;
};

/// What the page shows.
struct RegeneratedPaper {
  std::vector<checks::PaperSection> sections;
  charts::PreslidingLoops presliding;          ///< Figure 5, for the errata.
  std::vector<figures::ReportFigure> figures;  ///< By the paper's numbers.
  std::vector<PaperSource> sources;
  calibration::Provenance provenance;
};

/// Makes the pictures three quarters as large as a report's, in pixels alone: 22 of them stand on
/// one page, which stays below 2 MB.
void fit_to_page(std::vector<figures::ReportFigure>& figures);

/// How many items of a kind the paper has, how many are here, and of how many all is well: every
/// check holds, and a figure has its picture.
struct PaperTally {
  checks::ItemKind kind{};
  int printed{};
  int here{};
  int well{};
};

/// Of figures, tables and equations, in this order.
std::vector<PaperTally> tally_of(const RegeneratedPaper& paper,
                                 const std::vector<render::workers::DrawnFigure>& drawn);

/// Does no check fail, and is everything here?
bool is_all_well(const RegeneratedPaper& paper, const std::vector<PaperTally>& tallies);

/// The checks for machines:
/// {"schema": "tribolog-paper-2", "tool", "items": [{kind, number, section, title, checks: [{what,
/// kind, expected, ours, difference, allowed, unit, holds}], told: [...]}]}. A number that is not
/// finite is null; words stand where words are compared.
std::string paper_json(const RegeneratedPaper& paper);

/// UTF-8 HTML without script or link to the outside, in the style of the report.
/// @param calibration of the paper's joint: the tables of section 3.4.
/// @param json paper_json() of the same in English.
std::string paper_page(const RegeneratedPaper& paper, const calibration::Calibration& calibration,
                       const std::vector<render::workers::DrawnFigure>& drawn,
                       const std::string& json, wording::Language language = wording::Language{});

}  // namespace tribolog::paper::page
