#pragma once
// The manifest of the log that will be recorded from a plan.

#include <string>

#include "plan/experiment_plan.h"

namespace tribolog {

/// A manifest with the plan's recordings as time windows of one log, planned_log_name, whose clock
/// starts with the plan. Columns are named as in the set points, with torque_Nm for the effort, in
/// SI; the user corrects names and units that the drive's log has otherwise.
std::string plan_dataset_toml(const ExperimentPlan& plan);

}  // namespace tribolog
