#pragma once
// Internal to the verdict: each quantity's uncertainty budget (JCGM 100), from its interval as the
// recordings gave it and from what the manifest states about influences that no recording shows.
//
// The sensitivities are exponents: the gravity torque at the motor is proportional to the torque
// constant, the surrogate mass m = n G / (r g) inversely proportional to r and g, and so on. How a
// quantity depends on the gear ratio follows from the sides on which torque and angle were logged.

#include <vector>

#include "calibration/calibration.h"
#include "calibration/quantity_verdict.h"

namespace tribolog::verdict {

/// Doubts each quantity that is not found any more at a limit of what the manifest states of an
/// influence: that is in no budget.
void lower_verdicts_by_influences(const calibration::Calibration& calibration,
                                  std::vector<calibration::QuantityVerdict>& quantities);

/// Gives each quantity that has an estimate its budget.
void state_budgets(const calibration::Calibration& calibration,
                   std::vector<calibration::QuantityVerdict>& quantities);

/// What the reader must know about influences that are not stated; empty: all torques have theirs.
Statement what_is_not_stated(const calibration::Calibration& calibration,
                             const std::vector<calibration::QuantityVerdict>& quantities);

}  // namespace tribolog::verdict
