#pragma once
// A recording as CSV, in SI: t_s,q_rad[,dq_rad_s],torque_Nm[,z_rad][,dz_rad_s]; i_A instead of
// torque_Nm where the controller logs current.

#include <string>

#include "joint/recording.h"
#include "simulate/scenario.h"

namespace tribolog {

/// One header row and one row a sample, LF line ends. Every number is the shortest that reads back
/// to the same double, or has the decimals of `form`. Signals that the recording does not have are
/// left out.
/// @throw std::invalid_argument if a signal is not as long as the time.
std::string recording_csv(const Recording& recording, const LogForm& form = {});

}  // namespace tribolog
