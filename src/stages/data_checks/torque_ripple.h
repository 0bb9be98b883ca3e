#pragma once
// Internal to the checks: torque that is periodic in the motor's angle.

#include <vector>

#include "stages/data_checks/checked_recordings.h"

namespace tribolog {

struct RippleLine {
  double periods_per_turn{};  ///< Of the motor, as the stated gear ratio has it.
  double amplitude_Nm{};      ///< Motor side.
};

struct TorqueRipple {
  std::vector<RippleLine> lines;  ///< The strongest first; empty: none stands out of the noise.
  double motor_turns{};           ///< Of the longest stroke looked at; 0: none is long enough.
  double torque_range_Nm{};       ///< Of the strokes looked at.
};

/// Spectrum over the motor's angle of the strokes of the rough sweeps, less their slow part.
TorqueRipple find_torque_ripple(const CheckedDataset& data);

}  // namespace tribolog
