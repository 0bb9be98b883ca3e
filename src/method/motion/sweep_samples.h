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

/// The recordings of a sweep with those of their samples that take part: prepared once, and handed
/// to every stage that looks at the sweep. Refers to the recordings.
struct Sweep {
  Sweep() = default;
  /// @param of_sweep may be empty: no sweep was recorded.
  explicit Sweep(std::vector<const joint::Recording*> of_sweep);

  std::vector<const joint::Recording*> recordings;
  SweepSamples samples;

  /// Joint angle of a sample that takes part [rad].
  [[nodiscard]] double q_rad(std::size_t i) const {
    return recordings[samples.recording[i]]->q_rad[samples.index[i]];
  }
  /// Its driving torque, motor side [N·m].
  [[nodiscard]] double torque_Nm(std::size_t i) const {
    return recordings[samples.recording[i]]->torque_Nm[samples.index[i]];
  }
  /// Of each recording: which of its samples take part.
  [[nodiscard]] std::vector<std::vector<bool>> used() const;
};

}  // namespace tribolog::method::motion
