#pragma once
// A plan over time: joint angle and speed, with its parts marked and named.

#include <vector>

#include "figures/report_figure.h"
#include "plan/experiment_plan.h"

namespace tribolog::figures::experiments {

/// "plan-motion": angle, motor speed and ramp torque over the whole time; "plan-oscillation": the
/// first oscillation and the way to it, where there is one. Empty where nothing is planned.
std::vector<ReportFigure> plan_figures(const plan::ExperimentPlan& plan);

}  // namespace tribolog::figures::experiments
