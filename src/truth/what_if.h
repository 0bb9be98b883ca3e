#pragma once
// What if the joint has what its recordings cannot exclude: the identified joint is simulated with
// a lag of the torque, an asymmetry, friction by load or by angle, a warm-up and a drift of the
// offset, each as large as the half width of its 95 % interval, and identified again. The same
// noise is laid on with and without the effect, so that a single simulation shows what the effect
// does.

#include <vector>

#include "truth/truth_check.h"

namespace tribolog::truth {

/// An effect of which the recordings say nothing is left out, but for the lag: it is then taken to
/// be one sample.
/// @param without readings of the first simulation of the known-truth check: the same noise.
std::vector<calibration::WhatIf> what_if(const IdentifiedJoint& joint,
                                         const calibration::Calibration& calibration,
                                         const std::vector<Reading>& without,
                                         const PlainIdentification& identify,
                                         const TruthCheckOptions& options);

}  // namespace tribolog::truth
