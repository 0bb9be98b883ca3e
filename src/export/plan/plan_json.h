#pragma once
// All numbers of a plan.

#include <string>

#include "calibration/provenance.h"
#include "plan/expected_intervals.h"
#include "plan/experiment_plan.h"

namespace tribolog {

/// Schema "tribolog-plan-1": parts with their state, segments with their windows, assumptions, and
/// what to expect. SI, motor side unless a key says joint. The same plan gives the same bytes.
std::string plan_json(const ExperimentPlan& plan, const ExpectedIntervals& expected,
                      const Provenance& provenance);

}  // namespace tribolog
