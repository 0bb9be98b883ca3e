#pragma once
// The samples of a sweep that take part in a fit, and what is left out: shared by the stages that
// look at sweeps.

#include <cstddef>
#include <vector>

#include "joint/recording.h"
#include "method/motion/plateaus.h"

namespace tribolog::method::motion {

struct SweepSamples {
  bool constant_speed{};               ///< Plateaus carry the sweep; else all moving samples do.
  std::vector<std::size_t> recording;  ///< Index of the recording of each sample.
  std::vector<std::size_t> index;      ///< Index within it.
  std::vector<std::size_t> stroke;     ///< Runs of one direction, numbered in time.
  std::vector<double> direction;       ///< +1: joint angle rising, -1: falling.
  std::vector<double> speed_rad_s;     ///< Joint side, local slope.
  std::vector<double> acceleration_rad_s2;
  std::size_t left_out{};  ///< Rest, acceleration, reversal, settling, abrupt stops.

  [[nodiscard]] std::size_t size() const { return index.size(); }
  [[nodiscard]] bool both_directions() const;
};

/// @param recordings any number; those without motion contribute nothing.
SweepSamples select_sweep_samples(const std::vector<const joint::Recording*>& recordings);

}  // namespace tribolog::method::motion
