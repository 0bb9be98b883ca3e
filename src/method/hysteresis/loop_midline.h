#pragma once
// The mid-line of a steady loop: what is left of the torque when friction has cancelled.
//
// In a steady loop under a motion that is half-wave symmetric, friction is half-wave antisymmetric:
// Tf(t + P/2) = -Tf(t). Its mean over whole cycles is zero whatever the model, and the mean torque
// is gravity's alone. The same holds for the torque of inertia. Reading single points has no such
// protection.

#include <optional>
#include <vector>

#include "joint/recording.h"
#include "method/motion/oscillation_motion.h"
#include "statistics/estimate.h"

namespace tribolog {

struct LoopMidline {
  Estimate torque_Nm;    ///< Mean over the steady cycles, motor side.
  double mean_cos{1.0};  ///< Mean of cos(q - q_peak) over the same cycles.
  double mean_q_rad{};
  double cycles{};                ///< Whole cycles in the recording.
  double steady_cycles{};         ///< Those averaged.
  bool start_up_included{false};  ///< Only one cycle was recorded, start-up stroke and all.
  std::vector<double> cycle_means_Nm;
  /// Mid-line over the angle, (rising + falling branch) / 2, for figures.
  std::vector<double> q_rad;
  std::vector<double> midline_Nm;
};

/// @param white_noise_Nm of the torque samples; gives the interval where cycles are too few.
std::optional<LoopMidline> find_loop_midline(const Recording& recording,
                                             const OscillationMotion& motion, double q_peak_rad,
                                             double white_noise_Nm);

}  // namespace tribolog
