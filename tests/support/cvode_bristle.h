#pragma once
// The bristle equation through SUNDIALS' CVODE (BDF, dense Newton): an independent solver to check
// the exponential integrator against, and the peer it is timed against.

#include <span>
#include <vector>

#include "friction/lugre.h"
#include "simulate/motion.h"

namespace tribolog::test {

struct CvodeOptions {
  double relative_tolerance{1e-12};
  double absolute_tolerance_rad{1e-17};
  /// Bound of a step. At a reversal nothing moves, and the solver would choose a first step that
  /// skips the whole turn-over.
  double largest_step_s{1e-3};
  /// Times at which the motion reverses. The solver is stopped and started anew at each: an
  /// adaptive solver steps over them otherwise and reports success with a wrong answer.
  std::vector<double> reversals_s;
};

/// Fills z at t = 0, dt, 2 dt, ... from z = 0. @throw std::runtime_error if CVODE gives up.
void solve_bristle_with_cvode(const friction::LuGreFriction& friction,
                              const simulate::Motion& motion, double dt_s,
                              const CvodeOptions& options, std::span<double> z_rad);

/// Reversals of a sine that starts at its middle, up to `end_s`.
std::vector<double> sine_reversals(double frequency_Hz, double end_s);

}  // namespace tribolog::test
