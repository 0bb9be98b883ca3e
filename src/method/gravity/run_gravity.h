#pragma once
// Gravity from the runs at constant speed, without a sweep or in addition to it.
//
// Within a run speed and friction are constant, but the angle changes:
//   T = offset(run) + (G/n) cos(q - q_peak)
// with one offset for each plateau, which absorbs Coulomb and viscous friction and any offset of
// the day. Amplitude and angle come from all runs together.
//
// The residual is ripple, which repeats with the angle in every run: lines of its spectrum are
// removed first. In the remainder, samples at the same angle are not independent, nor are those of
// one run: the variance is that over blocks of the angle plus that over whole runs, less that over
// their intersections. Runs that travel less than a quarter of the longest one are left out: a
// short piece of a ripple looks like a slope of gravity.
//
// It fails where the drive lifts the load in every run: friction that grows with the load then
// looks like gravity. `always_lifts` indicates this.

#include <cstddef>
#include <optional>
#include <vector>

#include "base/statement.h"
#include "joint/recording.h"
#include "method/gravity/cog_sweep.h"
#include "method/gravity/ripple_spectrum.h"
#include "statistics/estimate.h"

namespace tribolog::method::gravity {

struct RunGravityResult {
  bool found{false};  ///< The values below are valid.
  Statement reason;   ///< Why not found; empty if it is.
  statistics::Estimate q_peak_rad;
  statistics::Estimate gravity_Nm;  ///< Amplitude G/n at the motor.
  Ripple ripple;                    ///< The part of the residual that repeats with the motor's
                                    ///< angle.
  double residual_Nm{};  ///< Standard deviation in cells of the angle, less fit and ripple.
  std::size_t runs_used{};
  std::size_t runs_left_out{};  ///< Plateaus with too short a travel.
  std::size_t samples_used{};
  double lowest_rad{};  ///< Range of the samples used, joint side.
  double highest_rad{};
  bool always_lifts{};  ///< The load drives the joint in no run, or in hardly any part of one.
};

/// @param recordings those of constant speed; may be empty.
/// @param gear_ratio n, of the motor's angle to the joint's.
/// @param of_angle what varies with the angle as no weight's torque does, from a sweep: taken off.
RunGravityResult identify_run_gravity(const std::vector<const joint::Recording*>& recordings,
                                      double gear_ratio,
                                      const std::optional<TorqueOfAngle>& of_angle = {});

}  // namespace tribolog::method::gravity
