#pragma once
// Gravity from the runs at constant speed, where no sweep exists or beside it.
//
// Within a run the speed stands still and so does friction, but the angle travels:
//   T = offset(run) + (G/n) cos(q - q_peak)
// with one offset for each plateau, which takes up Coulomb and viscous friction and whatever the
// day adds. Amplitude and angle come from all runs together.
//
// What is left is ripple, which repeats with the angle in every run: lines of its spectrum are
// taken out first. Of the rest, samples at the same angle are no independent witnesses, nor are
// those of one run: the variance is that of blocks of the angle plus that of whole runs, less that
// of what both have in common. Runs that travel less than a quarter of the widest one take no part:
// a short piece of a ripple looks like a slope of gravity.
//
// It fails where the drive lifts the load in every run: friction that grows with the load then
// looks like gravity. `always_lifts` says so.

#include <cstddef>
#include <vector>

#include "base/statement.h"
#include "joint/recording.h"
#include "method/gravity/ripple_spectrum.h"
#include "statistics/estimate.h"

namespace tribolog::method::gravity {

struct RunGravityResult {
  bool found{false};  ///< The values below are valid.
  Statement reason;   ///< Why not found; empty if it is.
  statistics::Estimate q_peak_rad;
  statistics::Estimate gravity_Nm;  ///< Amplitude G/n at the motor.
  Ripple ripple;                    ///< What of it repeats with the motor's angle.
  double residual_Nm{};  ///< Standard deviation of what fit and ripple leave in cells of the angle.
  std::size_t runs_used{};
  std::size_t runs_left_out{};  ///< Plateaus with too short a way.
  std::size_t samples_used{};
  double lowest_rad{};  ///< Range of the samples used, joint side.
  double highest_rad{};
  bool always_lifts{};  ///< In no run, or hardly any part of one, does the load drive the joint.
};

/// @param recordings those of constant speed; may be empty.
/// @param gear_ratio n, of the motor's angle to the joint's.
RunGravityResult identify_run_gravity(const std::vector<const joint::Recording*>& recordings,
                                      double gear_ratio);

}  // namespace tribolog::method::gravity
