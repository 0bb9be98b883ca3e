#pragma once
// The motion of a recorded oscillation: its frequency, its harmonics, its cycles.

#include <optional>
#include <vector>

#include "joint/recording.h"
#include "simulate/motion.h"

namespace tribolog {

struct OscillationMotion {
  double frequency_Hz{};
  double centre_rad{};
  double amplitude_rad{};  ///< Of the first harmonic.
  double start_s{};        ///< Time of the first sample; harmonics count time from here.
  double residual_rad{};   ///< Standard deviation of q less the harmonics.
  std::vector<HarmonicMotion::Harmonic> harmonics;  ///< Joint side.

  /// Motor-side motion as a function of the time since start_s.
  [[nodiscard]] HarmonicMotion motor_motion(double gear_ratio) const;
};

/// Fits `harmonics` harmonics and their frequency to the angle. Absent if the angle does not swing
/// through at least one cycle.
std::optional<OscillationMotion> fit_oscillation_motion(const Recording& recording,
                                                        int harmonics = 3);

}  // namespace tribolog
