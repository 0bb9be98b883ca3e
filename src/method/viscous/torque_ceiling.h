#pragma once
// Internal to the room: does the drive's limit, not the joint, set the torque of runs?
//
// Runs of different speeds whose mean torques are the largest and the same, while the runs of the
// other direction at these speeds differ: what friction does there, a limit hides. Noise on top of
// the limit hides it from anyone who looks for samples that repeat.

#include <cstddef>

#include "method/viscous/viscous_curves.h"

namespace tribolog::method::viscous {

struct TorqueCeiling {
  std::size_t runs{};  ///< On it; 0: there is none.
  double torque_Nm{};  ///< Motor side, signed.
};

TorqueCeiling torque_ceiling(const ViscousCurvesResult& curves);

}  // namespace tribolog::method::viscous
