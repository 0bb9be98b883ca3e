#pragma once
// Internal to the room: the samples of a plateau that count.
//
// A wild sample, or the end of a ramp that the plateau still holds, lies far outside what the
// others of the plateau scatter; a mean must not hang on it. Samples farther from the median than
// five standard deviations (from the median deviation, so that they do not widen it themselves)
// are left out, as long as they are few: where they are many, the plateau is not one.

#include <cstddef>
#include <vector>

#include "joint/recording.h"
#include "method/motion/plateaus.h"

namespace tribolog::method::viscous {

struct PlateauSamples {
  std::size_t first{}, last{};  ///< Of the plateau.
  std::vector<char> counts;     ///< Per sample of it.
  std::size_t left_out{};
  /// Standard error of a mean of this torque from its rounding to steps; 0: noise, or gravity on
  /// the way, carries it over several of them, or it is not rounded.
  double rounding_error_Nm{};

  [[nodiscard]] bool has(std::size_t i) const { return counts[i - first] != 0; }
  [[nodiscard]] std::size_t size() const { return counts.size() - left_out; }
};

/// @param friction_Nm torque less gravity, per sample of the plateau.
/// @param step_Nm that the torque is rounded to; 0: it is not.
PlateauSamples samples_that_count(const joint::Recording& recording, const motion::Plateau& plateau,
                                  const std::vector<double>& friction_Nm, double step_Nm);

}  // namespace tribolog::method::viscous
