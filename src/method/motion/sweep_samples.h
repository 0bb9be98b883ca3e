#pragma once
// The samples of a sweep that are used in fits, and what is left out: shared by the stages that use
// sweeps.

#include <cstddef>
#include <vector>

#include "joint/recording.h"
#include "method/motion/plateaus.h"

namespace tribolog::method::motion {

struct SweepSamples {
  bool constant_speed{};               ///< Samples on plateaus are used; else all moving samples.
  std::vector<std::size_t> recording;  ///< Index of the recording of each sample.
  std::vector<std::size_t> index;      ///< Index within it.
  std::vector<std::size_t> stroke;     ///< Stretches of one direction, numbered in time.
  std::vector<double> direction;       ///< +1: joint angle rising, -1: falling.
  std::vector<double> speed_rad_s;     ///< Joint side, local slope.
  std::vector<double> acceleration_rad_s2;
  std::size_t left_out{};  ///< Rest, acceleration, reversal, settling, abrupt stops.

  [[nodiscard]] std::size_t size() const { return index.size(); }
  [[nodiscard]] bool both_directions() const;
};

/// @param recordings any number; those without motion contribute nothing.
SweepSamples select_sweep_samples(const std::vector<const joint::Recording*>& recordings);

/// The recordings of a sweep with the samples that are used: prepared once, and passed to every
/// stage that uses the sweep. Refers to the recordings, which must outlive it.
struct Sweep {
  Sweep() = default;
  /// @param of_sweep may be empty: no sweep was recorded.
  explicit Sweep(std::vector<const joint::Recording*> of_sweep);

  std::vector<const joint::Recording*> recordings;
  SweepSamples samples;

  /// Joint angle of a used sample [rad].
  [[nodiscard]] double q_rad(std::size_t i) const {
    return recordings[samples.recording[i]]->q_rad[samples.index[i]];
  }
  /// Its driving torque, motor side [N·m].
  [[nodiscard]] double torque_Nm(std::size_t i) const {
    return recordings[samples.recording[i]]->torque_Nm[samples.index[i]];
  }
  /// For each recording: which of its samples are used.
  [[nodiscard]] std::vector<std::vector<bool>> used() const;
};

}  // namespace tribolog::method::motion
