#pragma once
// A plan as one HTML file that needs nothing else.

#include <string>
#include <vector>

#include "calibration/provenance.h"
#include "figures/report_figure.h"
#include "plan/expected_intervals.h"
#include "plan/experiment_plan.h"
#include "render/workers/renderer.h"
#include "wording/language.h"

namespace tribolog::report::experiments {

/// A plan, what to expect of it, and what it was made from.
struct PlanReport {
  plan::ExperimentPlan plan;
  plan::ExpectedIntervals expected;
  std::string joint_file;  ///< As named on the command line.
  std::string joint_text;
  calibration::Provenance provenance;
};

/// UTF-8 HTML without script or link to the outside, in the style of the report.
std::string plan_page(const PlanReport& report, const std::vector<figures::ReportFigure>& figures,
                      const std::vector<render::workers::DrawnFigure>& drawn,
                      wording::Language language = wording::Language{});

}  // namespace tribolog::report::experiments
