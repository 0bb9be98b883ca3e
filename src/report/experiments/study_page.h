#pragma once
// The Monte-Carlo study as one HTML file that needs nothing else.

#include <string>
#include <vector>

#include "calibration/provenance.h"
#include "figures/report_figure.h"
#include "render/workers/renderer.h"
#include "study/study.h"
#include "wording/language.h"

namespace tribolog::report::experiments {

/// A study and what it was made from.
struct StudyReport {
  study::StudyResult study;
  std::string scenario_file;  ///< As named on the command line; "examples/paper/..." if built in.
  std::string scenario_text;
  calibration::Provenance provenance;
};

/// UTF-8 HTML without script or link to the outside, in the style of the report. Figures and drawn
/// pictures pair up by id.
std::string study_page(const StudyReport& report, const std::vector<figures::ReportFigure>& figures,
                       const std::vector<render::workers::DrawnFigure>& drawn,
                       wording::Language language = wording::Language{});

/// All numbers of the study, schema "tribolog-study-1". The same study gives the same bytes.
std::string study_json(const StudyReport& report);

}  // namespace tribolog::report::experiments
