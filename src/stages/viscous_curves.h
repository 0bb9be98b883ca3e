#pragma once
// Stage 5: friction against motor speed, one curve per candidate mass, eq. (11):
// Tf = T - (G/n) cos(q - q_peak), averaged over each plateau of constant speed.
//
// Where no constant-speed run was recorded but a sweep of varying speed in both directions was,
// its samples are paired at equal angle instead: each angle gives a run of each direction.

#include <string>
#include <vector>

#include "joint/recording.h"
#include "stages/cog_sweep.h"
#include "stages/estimate.h"
#include "stages/surrogate_masses.h"

namespace tribolog {

/// One plateau, or one angle bin of a paired sweep in one direction.
struct ConstantSpeedRun {
  std::string recording;
  double speed_rad_s{};  ///< Motor side, signed.
  double torque_Nm{};    ///< Mean driving torque T, motor side (inertia and ripple removed).
  double torque_half_width_Nm{};  ///< 95 % of the mean.
  double q_rad{};                 ///< Mean joint angle.
  double mean_cos{};              ///< Mean of cos(q - q_peak) over it.
  std::size_t samples{};
  int partner{-1};  ///< Index of the run of opposite direction at the same speed; -1: none.
  /// (T(+v) - T(-v))/2 over the angles that both directions share, with this run's sign;
  /// NaN without a partner or a common angle.
  double direction_difference_Nm{};
  double direction_difference_half_width_Nm{};
  // For resampling, not stored.
  double mean_sin{};  ///< Mean of sin(q - q_peak).
  /// T less gravity, averaged over each of the run's blocks; empty if there are none.
  std::vector<double> block_friction_Nm;
};

struct ViscousCurve {
  std::string estimator;
  std::vector<double> friction_Nm;  ///< Per run, motor side, signed as the speed is.
};

struct ViscousCurvesResult {
  StageReport stage;
  std::vector<ConstantSpeedRun> runs;  ///< Sorted by speed.
  std::vector<ViscousCurve> curves;    ///< One per surrogate mass, in that order.
  bool from_sweep{};                   ///< Runs are angle bins of a sweep of varying speed.
  std::size_t samples_used{};
  std::size_t samples_left_out{};  ///< Rest, acceleration, reversal, settling.
  std::size_t recordings_without_plateau{};

  [[nodiscard]] const ViscousCurve* find(const std::string& estimator) const;
};

ViscousCurvesResult identify_viscous_curves(const std::vector<const Recording*>& runs,
                                            const CogSweepResult& rough,
                                            const SurrogateMassesResult& masses,
                                            const std::optional<Estimate>& q_peak_rad,
                                            double gear_ratio);

}  // namespace tribolog
