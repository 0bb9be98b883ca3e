#pragma once
// The paper's figures, regenerated.

#include <vector>

#include "figures/report_figure.h"
#include "paper/checks/papers_joint.h"

namespace tribolog::paper::checks {

/// In the order of their numbers: charts, drawings and scenes, and those of the identification.
std::vector<figures::ReportFigure> paper_figures(const PapersJoint& joint);

}  // namespace tribolog::paper::checks
