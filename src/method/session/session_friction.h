#pragma once
// What friction depends on beside the speed: the load, the joint's angle, the direction, and the
// time within the session. From all pairs of constant-speed strokes (condition_regression.h) and,
// for the time, from the oscillations too (friction_drift.h).
//
// Each effect is found where it is both certain (chance below 0.3 %, over blocks of what may hang
// together) and large enough to matter: half of what makes the friction parameters wrong. What is
// not found may be there below that.
//
// Friction of oscillations: work over a cycle by twice its travel, in which gravity, offset, ripple
// and inertia cancel.

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
  statistics::Estimate per_load;  ///< N·m of friction for each N·m of gravity torque.
  double friction_Nm{};           ///< Mean friction, at reference_load.
  double reference_load{};        ///< As a share of the gravity torque.
  double unloaded_Nm{};           ///< Without load.
  double at_peak_Nm{};            ///< Under all of the gravity torque.
  /// What load adds to the viscous coefficient of runs that cross less of it at higher speed.
  double viscous_Nms_rad{};
};

/// What else of friction changes with the joint's angle, as a share of friction.
struct AngleEffect {
  bool examined{};
  bool found{};
  statistics::Estimate amplitude;  ///< Half of largest less smallest, over the angles covered.
  double largest_at_rad{};
  double smallest_at_rad{};
};

struct DirectionEffect {
  bool examined{};
  bool asymmetry_found{};
  bool offset_found{};
  bool told_apart{};  ///< By several levels of friction; else either may be the other.
  /// Friction is larger by this share while the angle rises, smaller while it falls.
  statistics::Estimate asymmetry;
  statistics::Estimate offset_Nm;  ///< Of the torque at the mean level, motor side.
};

struct OffsetDrift {
  bool examined{};
  bool found{};
  statistics::Estimate change_Nm;  ///< From the session's begin to its end, motor side.
  /// From the rough sweep to the oscillations: what the mid-line's offset differs by from the
  /// sweep's. 0 without either.
  double to_oscillations_Nm{};
};

/// What a change of friction within a sweep does to what was read from it.
struct SweepShift {
  double q_peak_rad{};        ///< With the change that describes the levels best.
  double q_peak_slack_rad{};  ///< How far those that do it about equally well are from it, and the
                              ///< interval of the change.
  double gravity_Nm{};
  double gravity_slack_Nm{};
};

struct SessionFriction {
  bool examined{};     ///< There are pairs of strokes to look at.
  Statement sentence;  ///< What came of it; never empty.
  bool by_clock{};     ///< Times by the recordings' clock; else in their order.
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

/// What is known of gravity and sweeps before.
struct SessionInput {
  const std::vector<joint::Recording>& recordings;
  const motion::Sweep& rough_sweep;
  const gravity::CogSweepResult& rough;
  const motion::Sweep& precise_sweep;
  const gravity::CogSweepResult& precise;
  const gravity::RunGravityResult& run_gravity;
  double gear_ratio{};
};

SessionFriction examine_session_friction(const SessionInput& input);

}  // namespace tribolog::method::session
