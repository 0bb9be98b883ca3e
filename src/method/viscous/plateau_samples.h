#pragma once
// Internal to the viscous stage: the samples of a plateau that count.
//
// An outlier, or the end of a ramp that the plateau still includes, lies far outside the scatter of
// the plateau's other samples; the mean must not depend on it. Samples farther from the median than
// five standard deviations (estimated from the median absolute deviation, which they hardly affect)
// and than a thousandth of it are left out if they are few: where they are many, it is no plateau.

#include <cstddef>
#include <vector>

#include "joint/recording.h"
#include "method/motion/plateaus.h"

namespace tribolog::method::viscous {

struct PlateauSamples {
  std::size_t first{}, last{};  ///< Of the plateau.
  std::vector<char> counts;     ///< Per sample of it.
  std::size_t left_out{};
  /// Standard error of the mean torque due to rounding to steps; 0: noise, or gravity along the
  /// plateau, spreads it over several steps, or it is not rounded.
  double rounding_error_Nm{};

  [[nodiscard]] bool has(std::size_t i) const { return counts[i - first] != 0; }
  [[nodiscard]] std::size_t size() const { return counts.size() - left_out; }
};

/// @param friction_Nm torque less gravity, one per sample of the plateau.
/// @param taken_off_Nm for the inertia, one per sample of the recording: where it is more than a
/// twentieth of friction, what smoothing the acceleration left of it would count; those samples are
/// left out, unless they are most. Empty: nothing was taken off.
/// @param step_Nm that the torque is rounded to; 0: it is not.
PlateauSamples samples_that_count(const joint::Recording& recording, const motion::Plateau& plateau,
                                  const std::vector<double>& friction_Nm,
                                  const std::vector<double>& taken_off_Nm, double step_Nm);

}  // namespace tribolog::method::viscous
