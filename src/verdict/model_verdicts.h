#pragma once
// Internal to the verdict: what the one model of sweeps, runs and points says of the quantities
// (method/model/), and whether that can be used.
//
// A number is usable if its interval is narrower than the need, and the data do not contradict the
// model where it is read. Small effects are in the interval; what no interval can hold, such as a
// unit that nobody confirmed, stays a check.

#include <vector>

#include "calibration/calibration.h"
#include "calibration/quantity_verdict.h"
#include "verdict/rules.h"

namespace tribolog::verdict {

/// Gives the quantities that the model answers its number and its verdict.
void state_by_model(const calibration::Calibration& calibration,
                    const std::vector<BrokenRule>& broken,
                    std::vector<calibration::QuantityVerdict>& quantities);

/// Of the variance of what the loop fit shows, largest first; empty for other quantities.
std::vector<method::hysteresis::EffectShare> shares_of_loops(
    const calibration::Calibration& calibration, joint::Quantity quantity);

/// Doubts what loops and ramps show where the interval is wider than the need.
void doubt_wide_contacts(const calibration::Calibration& calibration,
                         std::vector<calibration::QuantityVerdict>& quantities);

/// Friction at the speeds of the model, rising.
std::vector<calibration::FrictionAtSpeed> friction_at_speeds(
    const calibration::Calibration& calibration, const std::vector<BrokenRule>& broken);

}  // namespace tribolog::verdict
