#pragma once
// What friction depends on besides speed: the load, the joint's angle, the direction, and the time
// within the session. From all pairs of constant-speed strokes (condition_regression.h) and, for
// the time, from the oscillations too (friction_drift.h).
//
// An effect counts as found where it is both significant (probability below 0.3 %, over blocks of
// what may be correlated) and large enough to matter: half of what makes the friction parameters
// wrong. A smaller effect may exist without being found.
//
// Friction of oscillations: work over a cycle divided by its total travel, in which gravity,
// offset, ripple and inertia cancel.

#include <optional>
#include <string>
#include <vector>

#include "base/statement.h"
#include "joint/recording.h"
#include "method/gravity/cog_sweep.h"
#include "method/gravity/run_gravity.h"
#include "method/motion/sweep_samples.h"
#include "method/session/friction_drift.h"
#include "statistics/estimate.h"

namespace tribolog::method::session {

/// Friction proportional to the gravity torque that loads the gear.
struct LoadEffect {
  bool examined{};
  bool found{};
  statistics::Estimate per_load;  ///< N·m of friction per N·m of gravity torque.
  double friction_Nm{};           ///< Mean friction, at reference_load.
  double reference_load{};        ///< As a share of the gravity torque.
  double unloaded_Nm{};           ///< Without load.
  double at_peak_Nm{};            ///< Under the full gravity torque.
  /// What the load adds to the viscous coefficient of runs that cross less load at higher speed.
  double viscous_Nms_rad{};
};

/// Further variation of friction with the joint's angle, as a share of friction.
struct AngleEffect {
  bool examined{};
  bool found{};
  statistics::Estimate amplitude;  ///< Half of largest minus smallest, over the angles covered.
  double largest_at_rad{};
  double smallest_at_rad{};
};

struct DirectionEffect {
  bool examined{};
  bool asymmetry_found{};
  bool offset_found{};
  bool told_apart{};  ///< Separated by several levels of friction; else either may be the other.
  /// Friction is larger by this share while the angle rises, and smaller while it falls.
  statistics::Estimate asymmetry;
  statistics::Estimate offset_Nm;  ///< Of the torque at the mean level, motor side.
};

struct OffsetDrift {
  bool examined{};
  bool found{};
  statistics::Estimate change_Nm;  ///< From the session's start to its end, motor side.
  /// From the rough sweep to the oscillations: difference of the mid-line's offset from the
  /// sweep's. 0 without either.
  double to_oscillations_Nm{};
};

/// Shift of a sweep's results by a change of friction during it.
struct SweepShift {
  double q_peak_rad{};        ///< With the change that describes the levels best.
  double q_peak_slack_rad{};  ///< Allows for changes that describe them about equally well, and for
                              ///< the interval of the change.
  double gravity_Nm{};
  double gravity_slack_Nm{};
};

struct SessionFriction {
  bool examined{};     ///< There are pairs of strokes to examine.
  Statement sentence;  ///< The outcome in words; never empty.
  bool by_clock{};     ///< Times by the recordings' clock; else by their order.
  double whole_s{};
  std::size_t pairs{};
  double mean_friction_Nm{};
  double gravity_Nm{};
  LoadEffect load;
  AngleEffect angle;
  DirectionEffect direction;
  FrictionDrift drift;
  OffsetDrift offset_drift;
  std::optional<SweepShift> rough_shift;  ///< Present where friction drifts.
  std::optional<SweepShift> precise_shift;
};

/// What is known of gravity and sweeps beforehand.
struct SessionInput {
  const std::vector<joint::Recording>& recordings;  ///< Those of the sweeps are among them.
  const motion::Sweep& rough_sweep;
  const gravity::CogSweepResult& rough;
  const motion::Sweep& precise_sweep;
  const gravity::CogSweepResult& precise;
  const gravity::RunGravityResult& run_gravity;
  double gear_ratio{};
};

SessionFriction examine_session_friction(const SessionInput& input);

}  // namespace tribolog::method::session
