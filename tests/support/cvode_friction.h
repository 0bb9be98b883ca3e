#pragma once
// Any friction model under prescribed motion through SUNDIALS' CVODE: an independent solver of the
// model's rates to check its own method against, and the peer that is timed.

#include <cstddef>
#include <span>
#include <vector>

#include "friction/friction_model.h"
#include "simulate/cvode_solver.h"
#include "simulate/motion.h"

namespace tribolog::test {

struct CvodeFrictionOptions {
  simulate::CvodeSolver::Method method{simulate::CvodeSolver::Method::bdf};
  double relative_tolerance{1e-12};  ///< And absolute, of each member's usual size.
  double largest_step_s{1e-3};
  /// After a stop: at a reversal nothing moves, and the solver's own choice would skip the turn.
  double first_step_s{1e-7};
  /// Times at which the motion reverses: the solver is stopped and started anew at each.
  std::vector<double> reversals_s;
  /// At events and reversals together. A loose tolerance can chatter about an event without end.
  int most_stops{100'000};
};

/// Fills the torque at t = 0, dt, 2 dt, ... from an unloaded contact. The solver takes its own
/// steps, samples are interpolated; it stops at reversals and at the model's events, where settle()
/// is called. Discrete members of the state are not among its unknowns.
/// @throw std::runtime_error if CVODE gives up or stops too often.
void friction_by_cvode(const friction::DynamicFriction& friction, const simulate::Motion& motion,
                       double dt_s, const CvodeFrictionOptions& options,
                       std::span<double> torque_Nm);

/// How many members of the state a motion moves: those that come first. The others are discrete.
std::size_t continuous_members(const friction::DynamicFriction& friction);

/// Times in (0, end] at which the motion reverses.
/// @param scan_s is shorter than the shortest time between two of them.
std::vector<double> reversals_of(const simulate::Motion& motion, double end_s, double scan_s);

}  // namespace tribolog::test
