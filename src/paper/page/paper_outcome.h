#pragma once
// Internal to the report: what the paper's page counts, and its list to tick off.

#include <string>
#include <vector>

#include "paper/page/paper_page.h"
#include "report/template_engine.h"

namespace tribolog::paper::page {

/// "Figure 15", "Table 2", "Equation 4", "The conclusions"
std::string item_name(const checks::PaperItem& item);
/// "figure-15"
std::string item_anchor(const checks::PaperItem& item);

/// The verdict over the page with every check that fails, the table of counts at the marker TALLY,
/// and the sections KIND of the list to tick off.
void fill_outcome_of(const RegeneratedPaper& paper,
                     const std::vector<render::workers::DrawnFigure>& drawn,
                     report::TemplateValues& values);

}  // namespace tribolog::paper::page
