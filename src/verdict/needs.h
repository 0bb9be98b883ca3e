#pragma once
// Internal to the verdict: how well a number has to be known. Half widths of a 95 % interval: of an
// angle in radian, of all else as shares of the estimate.

#include "calibration/calibration.h"

namespace tribolog::verdict {

/// For a number to be usable: by the manifest's limits, or what is usual.
double need_of(const calibration::Calibration& calibration, joint::Quantity quantity,
               double estimate);

/// The same of the whole interval, with what was stated to the program and no recording shows, such
/// as a torque constant: it is wide by no fault of the recordings.
double widest_with_stated(joint::Quantity quantity);

/// Beyond it the number is not known at all.
double widest_known(joint::Quantity quantity);

}  // namespace tribolog::verdict
