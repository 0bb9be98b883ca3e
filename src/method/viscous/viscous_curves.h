#pragma once
// Stage 5: friction against motor speed, one curve per candidate mass, eq. (11):
// Tf = T - (G/n) cos(q - q_peak), averaged over each plateau of constant speed.
//
// Where no constant-speed run was recorded but a sweep of varying speed in both directions was, its
// samples are paired at equal angle instead: each angle bin gives a run of each direction.

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "base/statement.h"
#include "joint/gravity_load.h"
#include "joint/recording.h"
#include "method/gravity/cog_sweep.h"
#include "method/hysteresis/surrogate_masses.h"
#include "method/motion/steady_runs.h"
#include "statistics/estimate.h"

namespace tribolog::method::viscous {

/// One plateau, or one angle bin of a paired sweep in one direction, or a friction point that was
/// read elsewhere: its angles are NaN, and it contains no gravity (mean_cos is 0).
struct ConstantSpeedRun {
  std::string recording;
  double speed_rad_s{};  ///< Motor side, signed.
  double torque_Nm{};    ///< Mean driving torque T, motor side (inertia and ripple removed).
  double torque_half_width_Nm{};      ///< 95 % of the mean.
  double torque_standard_error_Nm{};  ///< Of the mean, from the scatter within the run; 0: not
                                      ///< known.
  double q_rad{};                     ///< Mean joint angle.
  double mean_cos{};                  ///< Mean of cos(q - q_peak) over it.
  std::size_t samples{};
  int partner{-1};  ///< Index of the run of opposite direction at the same speed; -1: none.
  /// (T(+v) - T(-v))/2 over the angles that both directions share, with this run's sign; NaN
  /// without a partner or common angles.
  double direction_difference_Nm{};
  double direction_difference_half_width_Nm{};
  double mean_sin{};  ///< Mean of sin(q - q_peak).
  /// Mean of |cos(q - q_peak)|: load as a share of the gravity torque. For a friction point with a
  /// load: share of the gravity torque, or of the largest load where no gravity is known.
  double mean_load{};
  double lowest_rad{};  ///< Joint angles that it covers.
  double highest_rad{};
  /// (T(+v) + T(-v))/2 over the angles that both directions share, and the mean of cos(q - q_peak)
  /// there; the same for both partners. NaN without a partner.
  double direction_mean_Nm{};
  double direction_mean_cos{};

  /// A friction point has none.
  [[nodiscard]] bool has_angle() const { return !std::isnan(q_rad); }
};

/// Joint angles of the runs that travel at least a quarter of the longest travel.
struct DirectionAngles {
  bool has_rising{false};
  bool has_falling{false};
  double rising_low_rad{};
  double rising_high_rad{};
  double falling_low_rad{};
  double falling_high_rad{};

  [[nodiscard]] bool share_angles() const;
  /// Which angles each direction covers, and whether they share none.
  [[nodiscard]] Statement described() const;
};

struct ViscousCurve {
  hysteresis::Estimator estimator{};
  std::vector<double> friction_Nm;  ///< Per run, motor side, signed as the speed is.
};

struct ViscousCurvesResult {
  statistics::StageReport stage;
  std::vector<ConstantSpeedRun> runs;  ///< Sorted by speed.
  std::vector<ViscousCurve> curves;    ///< One per surrogate mass, in that order.
  DirectionAngles angles;
  bool from_sweep{};  ///< Runs are angle bins of a sweep of varying speed.
  std::size_t samples_used{};
  std::size_t samples_left_out{};  ///< Rest, acceleration, reversal, settling, outliers.
  std::size_t recordings_without_plateau{};

  [[nodiscard]] const ViscousCurve* find(std::optional<hysteresis::Estimator> estimator) const;
};

/// @param points of friction, which join the runs. The scatter of repeated points at one speed is
/// the uncertainty of each.
/// @param sweep the rough one, and what was found in it; paired at equal angle where no run was
/// recorded.
/// @param stated gravity known beforehand: the curve Estimator::stated, at its own angle of the
/// peak.
ViscousCurvesResult identify_viscous_curves(const motion::SteadyRuns& runs,
                                            const std::vector<joint::FrictionPoints>& points,
                                            const motion::Sweep& sweep,
                                            const gravity::CogSweepResult& rough,
                                            const hysteresis::SurrogateMassesResult& masses,
                                            const std::optional<statistics::Estimate>& q_peak_rad,
                                            double gear_ratio,
                                            const std::optional<joint::StatedGravity>& stated = {});

}  // namespace tribolog::method::viscous
