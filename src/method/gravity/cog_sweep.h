#pragma once
// Stages 1 and 2: the angle of the centre of gravity from slow sweeps.
//
// Paper: the joint angle at the largest driving torque (figures 13 and 14). Ours: least squares of
// T = Tf(direction, speed) + b cos q + c sin q + J q'' over the whole sweep, q_peak = atan2(c, b),
// gravity amplitude hypot(b, c). Terms of speed and acceleration are included only where the speed
// of the sweep varies; abrupt stops in such a sweep are left out, and friction that grows with the
// load is a further term where it improves the prediction of held-out strokes. Each direction has
// its own offset, so friction cancels where both were recorded. Over a long range at constant speed
// the twist of the gear under gravity is a term as well: the angle is then the link's, although the
// encoder is the motor's; a short sweep takes the twist from the long one.
//
// Close to the peak the torque is flat (1 degree off costs 1.5e-4 of it): a precise sweep alone
// cannot separate amplitude and offset in noise. Where a rough sweep is given, its amplitude is
// used and only the angle is fitted.

#include <optional>
#include <string>
#include <vector>

#include "base/statement.h"
#include "method/gravity/residual_causes.h"
#include "method/gravity/ripple_spectrum.h"
#include "method/motion/sweep_samples.h"
#include "statistics/estimate.h"

namespace tribolog::method::gravity {

/// Torque that varies with the joint's angle as no weight's does: of a spring, of hoses, of a
/// linkage, of an eccentric encoder. Motor side, in addition to gravity and offset.
struct TorqueOfAngle {
  double about_rad{};                ///< Origin of the angles: y = q - about.
  double cosine_Nm{};                ///< Of cos 2y.
  double sine_Nm{};                  ///< Of sin 2y.
  double spring_Nm{};                ///< Of y [N·m/rad].
  double amplitude_Nm{};             ///< Half of largest minus smallest, over the sweep.
  double slope_half_width_Nm_rad{};  ///< 95 % of its slope at the gravity peak [N·m/rad].

  [[nodiscard]] double torque_Nm(double q_rad) const;
};

/// A spring beside gravity, as hoses and cables may add, as large as a sweep does not exclude.
struct UnseenSpring {
  double per_radian_Nm{};  ///< Motor side, per radian of the joint.
  double on_angle_rad{};   ///< By which it would shift the gravity peak.
};

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
  /// Where Coulomb friction that grows with the load describes held-out strokes better: the
  /// unloaded part, and what the full gravity torque adds. Motor side.
  std::optional<statistics::Estimate> unloaded_coulomb_Nm;
  std::optional<statistics::Estimate> load_coulomb_Nm;
  std::optional<statistics::Estimate>
      viscous_Nms_rad;  ///< Per motor speed; only from a sweep of varying speed.
  std::optional<statistics::Estimate>
      inertia_kgm2;  ///< Reflected to the motor; only if accelerations show it.
  /// Twist of the gear under the full gravity torque, joint side; absent where the range is too
  /// short to distinguish it from a shifted peak.
  std::optional<statistics::Estimate> twist_rad;
  /// Present where the mean of both directions shows it in addition to gravity and a twist of the
  /// gear: it is then a term of the fit.
  std::optional<TorqueOfAngle> of_angle;
  /// Amplitude of a torque of the angle that was too large to be a term; 0: none.
  double torque_of_angle_left_Nm{};
  double offset_Nm{};  ///< Mean of both directions less gravity, motor side.
  /// The same with its interval, where both directions were recorded: an offset of the torque, or
  /// half the difference of the friction in the two directions.
  std::optional<statistics::Estimate> torque_offset_Nm;
  /// Amplitude of a torque of twice the angle that would pass for the offset, where the sweep does
  /// not exclude one: intervals include both. 0: it is an offset.
  double offset_of_angle_Nm{};
  /// Change of the offset from the start to the end of a recording.
  std::optional<statistics::Estimate> offset_drift_Nm;
  /// Of a sweep at constant speed in which no torque of the angle was found.
  std::optional<UnseenSpring> unseen_spring;
  double residual_Nm{};  ///< Standard deviation of the fit's residuals.
  /// Standard deviation of the part of the residual that is torque ripple: it repeats with the
  /// motor's angle, in both directions alike. 0 if none is visible. A loop at one position cannot
  /// average it out.
  double ripple_Nm{};
  Ripple ripple;  ///< Its periods, where the sweep is long enough to show them.
  std::vector<VibrationLine> vibration;  ///< The part of the residual that is periodic in time.
  double coloured_Nm{};  ///< Standard deviation of what is correlated in time without a period.
  double white_Nm{};     ///< That of white noise.
  double largest_acceleration_rad_s2{};  ///< Of the motor, in a sweep of varying speed.
  /// Standard deviation of what repeats with the angle, but reverses with the direction: friction
  /// that changes with the angle.
  double friction_by_angle_Nm{};
  Ripple friction_of_angle;  ///< Its periods, of a rising joint angle.
  /// Root mean square over the strokes of the mean residual of their friction: how far strokes of
  /// several speeds are from one straight line. 0 with fewer than four.
  double strokes_apart_Nm{};
  double lowest_rad{};  ///< Range of the samples used.
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

/// Shift of a sweep's results by an error, SI.
struct SweepShift {
  double q_peak_rad{};
  double gravity_Nm{};
  double coulomb_Nm{};
  double twist_rad{};
  double offset_Nm{};
};

/// What a resample needs to repeat the sweep's fit without its samples.
struct SweepBlocks {
  std::vector<SweepShift> shifts;  ///< Of each block of neighbours; see BlockRegression.
  double freedom{};                ///< Degrees of freedom of their scatter.
  double amplitude_lever{};        ///< Change of q_peak per change of a known gravity [rad/(N·m)].
  double twist_lever{};            ///< The same for a twist.
  std::vector<double> ripple_lever;  ///< Amplitude of q_peak per amplitude of each ripple line.
};

/// Which of the paper's two sweeps.
enum class SweepKind { rough, precise };

/// The sweep's stage: "cog_rough", "cog_precise".
std::string to_string(SweepKind kind);

/// Where the angle of the gravity peak was taken from.
enum class PeakSource { rough_sweep, precise_sweep, runs };

/// Stable: "cog_rough", "cog_precise", "runs".
std::string to_string(PeakSource source);

struct CogSweep {
  CogSweepResult result;
  SweepCurves curves;
  SweepBlocks blocks;
};

/// What a short sweep takes from a long one.
struct KnownOfSweep {
  bool has_no_gravity{};  ///< The manifest states none: only friction and offset are read.
  /// From starts and stops. In a sweep of varying speed its effect is nearly that of a twist of the
  /// gear or a spring: subtracting a known inertia makes these visible.
  std::optional<statistics::Estimate> inertia_kgm2;
  std::optional<statistics::Estimate> gravity_Nm;  ///< Amplitude at the motor.
  std::optional<double> q_peak_rad;  ///< With the amplitude: is it the peak or the trough here?
  std::optional<statistics::Estimate> twist_rad;  ///< Of the gear.
  std::optional<TorqueOfAngle> of_angle;
  /// A short sweep cannot average it out: the interval of its angle allows for the ripple at any
  /// phase.
  Ripple ripple;
};

/// @param sweep of the recordings of one role; without any, the stage is skipped and says so.
CogSweep identify_cog_sweep(SweepKind kind, const motion::Sweep& sweep, double gear_ratio,
                            const KnownOfSweep& known = {});

}  // namespace tribolog::method::gravity
