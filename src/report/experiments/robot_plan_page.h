#pragma once
// The plans of a robot's joints on one page: their order, how long all of it takes, what each joint
// does, and the way to its plan. One HTML file without script.

#include <string>
#include <vector>

#include "calibration/provenance.h"
#include "plan/expected_intervals.h"
#include "plan/experiment_plan.h"
#include "wording/language.h"

namespace tribolog::report::experiments {

struct RobotPlanJoint {
  std::string name;
  const plan::ExperimentPlan* plan{nullptr};         ///< Null: it could not be planned,
  std::string refusal;                               ///< for this reason.
  const plan::ExpectedIntervals* expected{nullptr};  ///< Null where the plan is.
  std::string file;  ///< Of its plan, beside the page; empty: there is none.
};

/// @param joints in the order in which they are measured, one or more. The numbers are embedded as
///        JSON, schema "tribolog-robot-plan-1", in the element "tribolog-robot-plan".
std::string robot_plan_page(const std::vector<RobotPlanJoint>& joints,
                            const calibration::Provenance& provenance,
                            wording::Language language = wording::Language{});

}  // namespace tribolog::report::experiments
