#pragma once
// The verdict on each quantity and the overall verdict, with the findings that they rest on.

#include "calibration/calibration.h"

namespace tribolog::verdict {

/// Each quantity is judged by what the stages found, by the checks on the data, and by the
/// manifest's limits. Overall: usable if every quantity that decides is usable and independent
/// estimates agree; not identifiable without the angle of the centre of gravity or without its
/// torque; else doubtful.
calibration::Judgement judge(const calibration::Calibration& calibration);

}  // namespace tribolog::verdict
