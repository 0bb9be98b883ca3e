#pragma once
// An inertia driven by a torque against a friction model: where the motion is the answer.
//
//   J dw/dt = T(t, angle, w) - friction(state, w)
//
// Solved by SUNDIALS' CVODE (BDF) with event location: an adaptive solver steps over reversals,
// which bend every friction model, and over the moments at which elements slip; it is stopped at
// each and started anew. Angle and torque may as well be displacement [m] and force [N].

#include <functional>
#include <string>
#include <vector>

#include "friction/friction_model.h"
#include "joint/recording.h"
#include "simulate/scenario.h"

namespace tribolog::simulate {

/// Samples at 0, dt, 2 dt, ...
struct ForcedMotion {
  std::vector<double> t_s;
  std::vector<double> angle_rad;
  std::vector<double> speed_rad_s;
  std::vector<double> applied_Nm;
  std::vector<double> friction_Nm;
  std::vector<double> end_state;  ///< Of the friction model, at the last sample.
};

struct ForcedMotionSetup {
  double inertia_kgm2{1.0};  ///< > 0
  /// Applied torque [N·m] by time, angle and speed.
  std::function<double(double t_s, double angle_rad, double speed_rad_s)> applied_Nm;
  double duration_s{};  ///< > 0
  double sample_s{};    ///< Interval dt > 0.
  double angle_rad{};   ///< At the start.
  double speed_rad_s{};
  /// Of the friction model at the start, as many numbers as it has; none: an unloaded contact.
  std::vector<double> friction_state{};
  double relative_tolerance{1e-9};
  /// Sizes below which errors do not count: of the angle, and of the speed.
  double least_angle_rad{1e-15};
  double least_speed_rad_s{1e-14};
  double largest_step_s{1e-3};
};

/// @throw Refusal for a value that is not allowed, or equations that the solver gives up.
ForcedMotion simulate_forced_motion(const friction::DynamicFriction& friction,
                                    const ForcedMotionSetup& setup);

// Break-away ramps of a scenario: the joint stands, its drive holds gravity, and the torque rises
// slowly until the joint slides. Here the motion is the answer:
//
//   (J + I/n^2) dw/dt = T(t) - Tf - (m g r / n) cos(q - q_peak),      phi = n q

/// One ramp from an unloaded contact, without the noise of a drive. It ends where the torque has
/// changed by largest_torque_Nm, or the joint has travelled largest_travel_rad.
/// @param direction +1 or -1, of the torque.
/// @throw Refusal for a ramp that cannot be carried out, or a joint without inertia.
joint::Recording simulate_break_away_ramp(const Scenario& scenario, const BreakAwayExperiment& ramp,
                                          double direction, std::string name);

}  // namespace tribolog::simulate
