#include "simulate/friction_response.h"

#include <stdexcept>

#include <fmt/format.h>

#include "parameter_rules.h"

namespace tribolog {
namespace {

/// Time of the sign change of the speed between two times of which it has opposite signs.
double reversal_between(const Motion& motion, double t0, double t1) {
  const bool starts_forward = motion.speed(t0) > 0;
  constexpr int halvings = 60;
  for (int i = 0; i < halvings; ++i) {
    const double middle = (t0 + t1) / 2;
    ((motion.speed(middle) > 0) == starts_forward ? t0 : t1) = middle;
  }
  return t1;
}

bool opposite(double a, double b) { return (a > 0 && b < 0) || (a < 0 && b > 0); }

}  // namespace

void advance_friction(const DynamicFriction& friction, const Motion& motion, double t0_s,
                      double t1_s, std::span<double> state) {
  const double middle_s = (t0_s + t1_s) / 2;
  const SpeedStep step{motion.speed(t0_s), motion.speed(middle_s), motion.speed(t1_s), t1_s - t0_s};
  double from = 0;
  double to = 0;
  if (opposite(step.start_rad_s, step.middle_rad_s)) {
    from = t0_s;
    to = middle_s;
  } else if (opposite(step.middle_rad_s, step.end_rad_s)) {
    from = middle_s;
    to = t1_s;
  } else if (opposite(step.start_rad_s, step.end_rad_s)) {  // the middle stands still
    from = t0_s;
    to = t1_s;
  } else {
    friction.advance(state, step);
    return;
  }
  // Speeds next to the reversal may have the wrong sign by rounding: there it is zero.
  const double turn = reversal_between(motion, from, to);
  friction.advance(state, {step.start_rad_s, motion.speed((t0_s + turn) / 2), 0.0, turn - t0_s});
  friction.advance(state, {0.0, motion.speed((turn + t1_s) / 2), step.end_rad_s, t1_s - turn});
}

void friction_response(const DynamicFriction& friction, const Motion& motion, double t0_s,
                       double dt_s, std::span<double> state, std::span<double> torque_Nm) {
  require_positive(dt_s, "sampling interval", "s");
  if (state.size() != friction.states()) {
    throw std::invalid_argument(fmt::format("the state has {} numbers, the model needs {}",
                                            state.size(), friction.states()));
  }
  for (std::size_t i = 0; i < torque_Nm.size(); ++i) {
    const double t = t0_s + static_cast<double>(i) * dt_s;
    if (i > 0) advance_friction(friction, motion, t - dt_s, t, state);
    torque_Nm[i] = friction.torque_Nm(state, motion.speed(t));
  }
}

}  // namespace tribolog
