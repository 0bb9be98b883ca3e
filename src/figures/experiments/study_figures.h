#pragma once
// The figures of a Monte-Carlo study: bias, scatter and coverage against each factor.

#include <vector>

#include "figures/report_figure.h"
#include "study/study.h"

namespace tribolog::figures::experiments {

/// Two for each factor: "study-gravity-<factor>" of the estimators of the gravity torque, and
/// "study-friction-<factor>" of the angle and the friction parameters; the latter is left out where
/// the factor's recordings show none of them. `stage` is the factor's key.
std::vector<ReportFigure> study_figures(const study::StudyResult& study);

}  // namespace tribolog::figures::experiments
