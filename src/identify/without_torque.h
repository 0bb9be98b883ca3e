#pragma once
// What is left of a calibration where no torque was recorded.

#include "calibration/calibration.h"

namespace tribolog {

/// Sets every stage's report: not identifiable, for want of torque, and what to record.
void refuse_for_want_of_torque(Calibration& calibration);

}  // namespace tribolog
