#pragma once
// Stages 1 and 2: the angle of the centre of gravity from slow sweeps.
//
// Paper: the joint angle at the largest driving torque (figures 13 and 14). Ours: least squares of
// T = Tf(direction, speed) + b cos q + c sin q + J q'' over the whole sweep, q_peak = atan2(c, b),
// gravity amplitude hypot(b, c). Terms of speed and acceleration are included only where the speed
// of the sweep varies. Each direction has its own offset, so friction cancels where both were
// recorded.
//
// It is a reading of one sweep, as the paper's: its interval holds the scatter of the samples and
// nothing else. What hoses, gears and sensors add is separated from gravity by the model of all
// recordings (method/model).
//
// Close to the peak the torque is flat (1 degree off costs 1.5e-4 of it): a precise sweep alone
// cannot separate amplitude and offset in noise. Where gravity is known, its amplitude is used and
// only the angle is fitted.

#include <optional>
#include <string>
#include <vector>

#include "base/statement.h"
#include "method/gravity/residual_causes.h"
#include "method/gravity/ripple_spectrum.h"
#include "method/motion/sweep_samples.h"
#include "statistics/estimate.h"

namespace tribolog::method::gravity {

struct CogSweepResult {
  statistics::StageReport stage;
  bool found{false};  ///< The values below are valid.
  Statement method;   ///< The equation that was fitted.

  double argmax_rad{};      ///< By the paper's method.
  double argmax_low_rad{};  ///< Angles that noise makes indistinguishable from the arg-max.
  double argmax_high_rad{};
  double argmax_torque_Nm{};  ///< Motor side, at the arg-max.
  bool argmax_at_end{};       ///< The maximum lies at the sweep's end: no peak was crossed.

  statistics::Estimate q_peak_rad;                 ///< Ours; of the link.
  statistics::Estimate gravity_Nm;                 ///< Gravity amplitude G/n at the motor.
  std::optional<statistics::Estimate> coulomb_Nm;  ///< Half the difference of the directions, motor
                                                   ///< side; at the mean load of the sweep.
  std::optional<statistics::Estimate>
      viscous_Nms_rad;  ///< Per motor speed; only from a sweep of varying speed.
  std::optional<statistics::Estimate>
      inertia_kgm2;    ///< Reflected to the motor; only if accelerations show it.
  double offset_Nm{};  ///< Mean of both directions less gravity, motor side.
  /// The same with its interval, where both directions were recorded: an offset of the torque, or
  /// half the difference of the friction in the two directions.
  std::optional<statistics::Estimate> torque_offset_Nm;
  double residual_Nm{};  ///< Standard deviation of the fit's residuals.
  /// Standard deviation of the part of the residual that is torque ripple: it repeats with the
  /// motor's angle, in both directions alike. 0 if none is visible. A loop at one position cannot
  /// average it out.
  double ripple_Nm{};
  Ripple ripple;  ///< Its periods, where the sweep is long enough to show them.
  std::vector<VibrationLine> vibration;  ///< The part of the residual that is periodic in time.
  double coloured_Nm{};  ///< Standard deviation of what is correlated in time without a period.
  double white_Nm{};     ///< That of white noise.
  /// Standard deviation of what repeats with the angle, but reverses with the direction: friction
  /// that changes with the angle.
  double friction_by_angle_Nm{};
  Ripple friction_of_angle;  ///< Its periods, of a rising joint angle.
  double lowest_rad{};       ///< Range of the samples used.
  double highest_rad{};
  bool both_directions{};
  bool constant_speed{};  ///< Plateaus were used; else the varying-speed fit.
  std::size_t samples_used{};
  std::size_t samples_left_out{};  ///< Rest, acceleration, reversal.
};

/// What figures show of a sweep besides its numbers.
struct SweepCurves {
  /// Of each recording of the role, in the dataset's order: which of its samples were used.
  std::vector<std::vector<bool>> used;
  /// Joint angles of all samples, including those where the joint starts and stops; equal if there
  /// are no samples.
  double lowest_rad{};
  double highest_rad{};
  /// Fitted motor-side torque: rising and falling joint angle.
  std::vector<double> fit_q_rad;
  std::vector<double> fit_rising_Nm;
  std::vector<double> fit_falling_Nm;  ///< Empty if only one direction was recorded.
};

/// Which of the paper's two sweeps.
enum class SweepKind { rough, precise };

/// The sweep's stage: "cog_rough", "cog_precise".
std::string to_string(SweepKind kind);

/// Where the angle of the gravity peak was taken from.
enum class PeakSource { model, rough_sweep, precise_sweep };

/// Stable: "model", "cog_rough", "cog_precise".
std::string to_string(PeakSource source);

struct CogSweep {
  CogSweepResult result;
  SweepCurves curves;
};

/// Gravity at the motor, as other recordings show it.
struct KnownGravity {
  double amplitude_Nm{};  ///< > 0
  double q_peak_rad{};    ///< Is it the peak or the trough here?
};

/// @param sweep of the recordings of one role; without any, the stage is skipped and says so.
/// @param has_gravity false: the manifest states none, and only friction and offset are read.
/// @param known its amplitude is taken, and the angle alone fitted.
CogSweep identify_cog_sweep(SweepKind kind, const motion::Sweep& sweep, double gear_ratio,
                            bool has_gravity = true, const std::optional<KnownGravity>& known = {});

}  // namespace tribolog::method::gravity
