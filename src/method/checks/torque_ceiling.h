#pragma once
// Internal to the room: does the drive's limit, not the joint, set the largest torque of runs?
//
// Runs of different speeds whose largest torques are the same, while those of the other direction
// at these speeds differ: what friction does there, a limit hides. Noise on top of the limit hides
// it from anyone who looks for samples that repeat.

#include <cstddef>
#include <vector>

#include "method/checks/checked_recordings.h"

namespace tribolog::method::checks {

struct TorqueCeiling {
  std::size_t speeds{};  ///< Of which the largest torque lies on it; 0: there is none.
  double torque_Nm{};    ///< Motor side, signed.
};

TorqueCeiling torque_ceiling(const std::vector<CheckedRecording>& recordings);

}  // namespace tribolog::method::checks
