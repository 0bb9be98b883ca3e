#pragma once
// The paper's argument put to another joint, as one HTML file that needs nothing else.

#include <string>
#include <vector>

#include "calibration/calibration.h"
#include "calibration/provenance.h"
#include "figures/report_figure.h"
#include "paper/claims/claims.h"
#include "paper/page/paper_page.h"
#include "render/workers/renderer.h"
#include "wording/language.h"

namespace tribolog::paper::page {

struct ArguedPaper {
  std::string joint;  ///< The scenario's name.
  std::vector<claims::Claim> claims;
  std::vector<figures::ReportFigure> figures;  ///< Those of the paper's numbers 11 to 22.
  PaperSource source;
  calibration::Provenance provenance;
};

/// How many claims the joint answers, and how many hold there.
struct ClaimTally {
  int asked{};
  int hold{};
};
ClaimTally tally_of(const std::vector<claims::Claim>& claims, bool on_papers_joint);

/// {"schema": "tribolog-claims-1", "tool", "joint", "claims": [{of, where, claim, papers_joint:
/// {holds, found}, this_joint: {holds, found}}]}; holds is null where it cannot be asked.
std::string claims_json(const ArguedPaper& paper);

/// UTF-8 HTML without script or link to the outside, in the style of the report.
/// @param calibration of this joint: the tables of section 3.4.
/// @param json claims_json() of the same in English.
std::string claims_page(const ArguedPaper& paper, const calibration::Calibration& calibration,
                        const std::vector<render::workers::DrawnFigure>& drawn,
                        const std::string& json, wording::Language language = wording::Language{});

}  // namespace tribolog::paper::page
