#pragma once
// Break-away ramps: the joint stands, the torque rises slowly until it slides.
//
// Before break-away the contact yields a little under the rising torque: pre-sliding. At break-away
// it yields without limit. The instant is found without an absolute scale: where the joint, over a
// tenth of its travel so far (and at least twenty of its usual steps), moves `yield_at_break_away`
// times faster than on average since the start of the ramp. A LuGre contact does so 0.7 % below its
// static torque, whatever its stiffness and the rate. A heavy joint that runs away slowly never
// does: its mean speed grows as well. It has broken away where it moves `speed_up_at_break_away`
// times faster than up to half of the torque, which a LuGre contact also does 0.7 % below its
// static torque.
//
// Where the torque rises fast for the contact, the joint is already accelerating when it is seen to
// yield, and the reading exceeds the friction. The part of the ramp before that is free of this
// error: the bristles deflect as
//
//   Tf(x) = Ts - (Ts - T0) exp(-x / d)
//
// (LuGre over a travel x in the limit of zero speed; T0 at the start, d = Ts / s0), and Ts is the
// level to which that part tends. That level is stated where the ramps bend far enough to show it,
// all but a third; it is compared with the reading, and their difference goes into the interval,
// for another contact has a different bend. While the torque rises, the bristle's damping holds
// s1/s0 times its rate; that is taken off where loops show both.
//
// Friction may change with the motor's angle, and a ramp has that of the angle at which it starts.
// The break-away torque meant is the mean over all angles (ramp_mean.h).
//
// A ramp that ends before that shows only that friction is larger than what was reached: a censored
// value, which counts with the probability that the joint holds more.

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "joint/recording.h"
#include "method/hysteresis/lugre_fit.h"
#include "statistics/estimate.h"

namespace tribolog::method::hysteresis {

inline constexpr double yield_at_break_away = 30;
inline constexpr double speed_up_at_break_away = 100;

/// Gravity torque at the motor, to be subtracted from the driving torque.
struct KnownGravity {
  statistics::Estimate amplitude_Nm;
  double q_peak_rad{};

  [[nodiscard]] double torque_Nm(double q_rad) const {
    return amplitude_Nm.value * std::cos(q_rad - q_peak_rad);
  }
};

/// By how much time the bristle's torque is behind the logged one while that rises.
struct BehindTorque {
  double time_s{};  ///< Damping over stiffness of the bristle, less a lag of the torque's log.
  double half_width_s{};
};

struct BreakAwayRamp {
  std::string recording;
  bool is_rising{};                ///< The torque rises to positive values.
  bool broke_away{};               ///< false: censored, friction_Nm is a lower bound.
  double rate_Nm_s{};              ///< Mean rate of the torque up to break-away, motor side, >= 0.
  double torque_Nm{};              ///< Driving torque at break-away, motor side, signed.
  double friction_Nm{};            ///< Magnitude, gravity and inertia subtracted (if known).
  double inertia_Nm{};             ///< What was subtracted for inertia, in the ramp's direction.
  double inertia_half_width_Nm{};  ///< Within which that is known: the joint runs away just then.
  /// Level to which friction tends in the resting part, a magnitude; absent where that does not
  /// bend over, or shows too few distinct angles.
  std::optional<double> level_Nm;
  double travel_rad{};     ///< Joint travel from rest up to break-away.
  double largest_yield{};  ///< Largest ratio of speed to mean speed up to break-away.
  double q_start_rad{};    ///< Joint angle at rest.
  /// Travel of the first slip, if the joint stopped again under a torque that still rose: caught by
  /// gravity, or by friction that changes with the angle. Absent: it slid on to the ramp's end.
  std::optional<double> first_slip_rad;
  /// Mean joint speed, if the joint never ran away but slid on at an even speed, as by a ramp of
  /// the position: level_Nm is then friction at that speed.
  std::optional<double> even_slide_rad_s;
  std::size_t samples_used{};  ///< Up to break-away.
  std::size_t samples_left_out{};
};

struct BreakAwayResult {
  statistics::StageReport stage;
  std::optional<KnownGravity> gravity;  ///< What was taken off the driving torque.
  std::vector<BreakAwayRamp> ramps;
  std::size_t censored{};
  bool is_level{};  ///< The values are the ramps' levels, not their readings.
  /// Relative difference of levels and readings beyond their scatter, of the direction where it is
  /// larger.
  double apart{};
  std::size_t positions{};  ///< Motor angles at which ramps broke away.
  /// What ramps at several angles differ by beyond the scatter at one, as a share (standard
  /// deviation); 0 if nothing.
  double between_positions{};
  /// Break-away torque by the direction of the torque, motor side, a magnitude; interval from the
  /// scatter of the ramps, absent with fewer than two that broke away.
  std::optional<statistics::Estimate> rising_Nm;
  std::optional<statistics::Estimate> falling_Nm;
  /// Mean of the two directions, in which gravity cancels where it was not subtracted.
  std::optional<statistics::Estimate> mean_Nm;

  /// Of ramps that broke away in one direction alone, where gravity is taken off or there is none.
  [[nodiscard]] std::optional<statistics::Estimate> of_one_direction_Nm() const {
    if (mean_Nm || !gravity) return std::nullopt;
    return rising_Nm ? rising_Nm : falling_Nm;
  }

  /// A driving torque at q_rad less the gravity taken off, in the ramp's direction [N·m].
  [[nodiscard]] double torque_along(bool is_rising, double torque_Nm, double q_rad) const {
    const double rest_Nm = torque_Nm - (gravity ? gravity->torque_Nm(q_rad) : 0.0);
    return is_rising ? rest_Nm : -rest_Nm;
  }
};

/// What else is known of a joint whose ramps are read.
struct KnownOfRamps {
  std::optional<KnownGravity> gravity{};
  /// Of all that turns: torque at the motor per joint acceleration [N·m s²/rad]; its torque at the
  /// reading is subtracted. 0: unknown, nothing is subtracted.
  double inertia_at_joint{0};
  double gear_ratio{1};
  /// Its change of friction with the angle acts on the ramps.
  gravity::CogSweepResult sweep{};
  BehindTorque behind{};  ///< Of a bristle whose damping is not known: zero.
  /// Typical share by which friction changes over the motor's turn (joint/effects.h, motor_turn).
  double friction_of_turn{0};
  bool is_lugre{false};  ///< The contact is stated to be LuGre's, whose bend shows the level.
};

/// @param ramps recordings of that role; may be empty (the stage is then skipped and says so).
BreakAwayResult identify_break_away(const std::vector<const joint::Recording*>& ramps,
                                    const KnownOfRamps& known);

/// The means as they are at the mean load, place and time of the runs.
/// @param difference by which share of itself friction was another where the ramps were recorded;
/// absent: not known, and nothing is changed.
void refer_to_runs(const std::optional<statistics::Estimate>& difference, BreakAwayResult& ramps);

// The level at which hysteresis loops flatten, compared with torque ramps that made the joint slide
// or not.

/// Removes the static torque, and what was read relative to it, from what the fit shows, with the
/// reason, where ramps show that the joint holds more: its loops then creep, and do not flatten
/// because of break-away.
LuGreFit against_ramps(LuGreFit fit, const BreakAwayResult& ramps);

}  // namespace tribolog::method::hysteresis
