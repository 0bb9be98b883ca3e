#pragma once
// Rows that the log lost, one or a few in a row: their time stamps tell.

#include "joint/recording.h"

namespace tribolog::method::motion {

/// The recording's time, angle and torque with rows in place of few lost ones, as if none had been:
/// the angle on the cubic through its neighbours, the torque on the straight line. What takes
/// differences from sample to sample needs them. A longer gap stays, and a recording without lost
/// rows is as it was.
joint::Recording with_lost_rows(const joint::Recording& recording);

/// Whether there are any that with_lost_rows() puts in place.
bool has_lost_rows(const joint::Recording& recording);

}  // namespace tribolog::method::motion
