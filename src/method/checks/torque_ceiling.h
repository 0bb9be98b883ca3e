#pragma once
// Internal to the checks: does the drive's limit, not the joint, determine the largest torque of
// runs?
//
// Runs of different speeds whose largest torques are equal, while those of the other direction at
// these speeds differ: a limit hides the effect of friction. Noise on top of the limit hides it
// from a search for repeated samples. A torque that is cut off stays there; a peak of one that
// swings, as when another joint moves, reaches the same height now and then by chance.

#include <cstddef>
#include <vector>

#include "method/checks/checked_recordings.h"

namespace tribolog::method::checks {

struct TorqueCeiling {
  std::size_t speeds{};  ///< Number of speeds whose largest torque lies on it; 0: there is none.
  double torque_Nm{};    ///< Motor side, signed.
};

TorqueCeiling torque_ceiling(const std::vector<CheckedRecording>& recordings);

}  // namespace tribolog::method::checks
