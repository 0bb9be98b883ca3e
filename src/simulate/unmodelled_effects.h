#pragma once
// What real joints and real logs do that the method's model does not: each an effect of its own, of
// a stated size, to be laid on a simulated joint. All zero: the model's own joint.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "joint/effects.h"
#include "joint/recording.h"

namespace tribolog::simulate {

struct Scenario;

/// Of the joint: these change the torque that a motion takes.
struct JointEffects {
  /// Share of the load's torque that the gear loses against the motion, 1 - efficiency; it changes
  /// sides at once where the motion turns round.
  double gear_loss{};
  /// Share of the load's torque by which friction grows; it builds up with the contact's own.
  double load_friction{};
  /// Friction is larger by this share while it holds back a rising angle, and smaller while it
  /// holds back a falling one.
  double direction_asymmetry{};
  double torque_offset_Nm{};  ///< Motor side.
  double offset_drift_Nm{};   ///< Grows to this over the session, motor side.
  double warm_up{};  ///< Share of the friction that is lost over the session, in an exponential.
  double
      friction_by_angle{};  ///< Friction is larger and smaller by this share, twice a joint turn.
  /// The same over the motor's angle: friction times 1 + this cos(periods theta + phase).
  double friction_by_motor_angle{};
  double periods_per_motor_turn{2};   ///< Of that; need not be whole.
  double phase_of_motor_angle_rad{};  ///< Of that.
  /// In place of c w the viscous torque is c w |w / w0|^(exponent - 1), with c and w0 below: the
  /// same at w0.
  double viscous_exponent{1};
  double bent_viscous_Nms_rad{};  ///< c, motor side: what the contact has of viscous friction.
  double bent_viscous_rad_s{1};   ///< w0 > 0, motor side.
  /// Twist of the gear under the largest gravity torque [rad, joint side]; the angle is the
  /// motor's.
  double gear_windup_rad{};
  double uneven_windup{};       ///< That twist is larger and smaller by this share, once a turn.
  double spring_Nm_rad{};       ///< Of a hose or a spring about the gravity peak, motor side.
  double twice_the_angle_Nm{};  ///< Of cos 2(q - q_peak), motor side.
  /// Share of the friction that the controller gives by itself and does not log, at speeds well
  /// beyond the one below, by the hyperbolic tangent.
  double taken_off{};
  double taken_off_from_rad_s{1};  ///< Motor side.
  double gravity_left_out{};       ///< Share of gravity that the controller gives and does not log.
  double tool_gravity{};      ///< From the first run on the load's gravity is larger by this share.
  std::size_t foreign_run{};  ///< Number of a run, from 1, that is of another joint; 0: none is.
  double foreign_friction{1};  ///< Friction of that joint over this one's.
  double second_harmonic{};    ///< Of an oscillation's motion, as a share of its amplitude.
  double third_harmonic{};     ///< The same.

  [[nodiscard]] bool any() const;
};

/// Of the drive and its log: these change what is written down.
struct LogEffects {
  double torque_delay_s{};    ///< The torque is logged so much later than the angle; < 0: earlier.
  double torque_filter_Hz{};  ///< First-order low pass of the torque; 0: none.
  double resonance_Hz{};      ///< Resonance of a second-order low pass of the torque; 0: none.
  double resonance_quality{3};  ///< Its gain there, > 0.5.
  double torque_mean_s{};    ///< The torque is logged as its mean over so long before; 0: as it is.
  double torque_scale{1.0};  ///< Logged over true: a torque constant that is off.
  double scale_of_loops{1.0};   ///< The same of oscillations alone.
  double scale_of_runs{1.0};    ///< The same of runs at constant speed alone.
  double saturation_per_Nm2{};  ///< T is logged as T (1 + this T^2), motor side: the drive's torque
                                ///< constant falls with its current.
  double saturation_per_Nm{};   ///< T is logged as T (1 + this |T|), motor side.
  double dead_zone_Nm{};        ///< Logged beyond T on either side of zero, motor side.
  double torque_limit_Nm{};     ///< Larger torques are logged as this, motor side; 0: none are.
  /// Of a controller's friction model, which is added to what is logged: this by the hyperbolic
  /// tangent of the speed, motor side.
  double coulomb_model_Nm{};
  double coulomb_model_from_rad_s{1};  ///< Speed of that tangent, > 0, joint side.
  /// What a sensor adds over the joint's angle: this times sin a + sin 2a, motor side.
  double crosstalk_Nm{};
  double crosstalk_zero_rad{};  ///< Angle from which that a counts.
  double touch_Nm{};  ///< Largest torque of a hand that leans on the arm in each sweep and in some
                      ///< of the runs, motor side.
  double tare_Nm{};   ///< Standard deviation of an offset of each recording's own, motor side.
  double vibration_Nm{};  ///< Amplitude of a torque periodic in time, motor side.
  double vibration_Hz{};
  double coloured_Nm{};      ///< Standard deviation of noise that hangs together in time.
  double coloured_time_s{};  ///< For so long.
  double
      neighbour_Nm{};  ///< Amplitude of gravity's change by another joint that moves, motor side.
  double neighbour_Hz{};
  double outlier_percent{};   ///< Of the samples of the torque.
  double outlier_Nm{};        ///< Size of such a sample's error, motor side.
  double held_percent{};      ///< Of the samples: the torque is stuck at an earlier value.
  double repeated_percent{};  ///< Of the rows: all channels are stuck at those of an earlier one.
  double dead_percent{};      ///< Of the recordings: the torque is stuck all along.
  double speed_scale{1.0};    ///< Logged over true.
  double wrap_rad{};          ///< The angle is logged modulo this, about zero; 0: as it is.
  double jump_rad{};          ///< Of the angle in each rough sweep, after a third of it.
  double homed_anew_rad{};    ///< Added to the angle of all but the rough sweeps.
  double lost_percent{};      ///< Of the rows.
  bool mirrored_angle{};      ///< The angle counts the other way round.
  bool mirrored_torque{};     ///< The torque counts the other way round.

  [[nodiscard]] bool any() const;
};

/// A motion with the friction in it, before the torque that drives it is put together.
struct MovedJoint {
  joint::Recording recording;  ///< Its torque is the friction's alone, motor side.
  std::vector<double> ddq_rad_s2;
  double static_Nm{};  ///< Of the contact: friction counts as built up by its share of this. 0: at
                       ///< once.
  std::size_t run{};   ///< Number of a run at constant speed, from 1; 0: another recording.
};

/// Effects of the catalogue that are not in a scenario, each of size zero. Where joint or log have
/// an effect none is stated: in a fit it may look like others.
joint::EffectSizes absent_effects(const Scenario& scenario);

/// Session time of the joint's effects: when a recording begins, and how long all of them take.
struct SessionClock {
  double start_s{};
  double whole_s{};
};

/// Turns friction into driving torque, eq. (8), with the joint's effects in it.
void put_together(const Scenario& scenario, const SessionClock& clock, MovedJoint& moved);

/// Torque that a spring, a hose or a linkage adds to gravity's, motor side.
double torque_of_angle_Nm(const Scenario& scenario, double q_rad);

/// Torque of the load [N·m], joint side, in a recording of that role: after a change of the tool
/// another one.
double load_torque_Nm(const Scenario& scenario, double q_rad, joint::Role role);

/// Share of it that the controller gives and does not log, motor side.
double left_out_Nm(const Scenario& scenario, double q_rad, joint::Role role);

/// What the joint's effects make of friction in sliding: it is `factor` times as large and by
/// `of_load_Nm` larger, motor side.
struct FrictionChange {
  double factor{1};
  double of_load_Nm{};
};

/// @param direction of the motion, +1 or -1. @param share_of_session that has passed, 0 to 1.
FrictionChange friction_change(const Scenario& scenario, double q_rad, double direction,
                               double share_of_session, joint::Role role);

/// What a break-away ramp meets: friction times this.
/// @param direction of the torque, +1 or -1.
double friction_factor_of_ramp(const Scenario& scenario, double q_rad, double direction);

/// What the torque has before noise is added to it: vibration and the neighbour's gravity, filter
/// and delay, noise that hangs together in time, the scale.
/// @param stream number of the recording: its random numbers and phases are its own.
void add_torque_effects(joint::Recording& recording, const LogEffects& effects,
                        double sample_rate_Hz, std::uint64_t seed, std::uint64_t stream);

/// What becomes of the logged values, noise and steps included: outliers, the limit, held and dead
/// torque, the speed's scale, wraps, the other sign. @param stream as above.
void add_log_effects(joint::Recording& recording, const LogEffects& effects, std::uint64_t seed,
                     std::uint64_t stream);

}  // namespace tribolog::simulate
