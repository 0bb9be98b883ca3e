#include "simulate/friction_response.h"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "base/requirements.h"
#include "simulate/motion.h"

namespace tribolog::simulate {
namespace {

constexpr std::size_t block_steps = 256;

/// Of a step that reverses: the first of its reversals that its three speeds tell of.
double turn_within(const Motion& motion, double t0_s, const friction::SpeedStep& step) {
  const double middle_s = t0_s + step.duration_s / 2;
  const double t1_s = t0_s + step.duration_s;
  if (step.start_rad_s * step.middle_rad_s < 0) {
    return reversal_time(motion, t0_s, middle_s, step.start_rad_s < 0);
  }
  if (step.middle_rad_s * step.end_rad_s < 0) {
    return reversal_time(motion, middle_s, t1_s, step.middle_rad_s < 0);
  }
  return reversal_time(motion, t0_s, t1_s, step.start_rad_s < 0);  // the middle stands still
}

/// Advances over a step, cut wherever it reverses.
void advance_cut(const friction::DynamicFriction& friction, const Motion& motion, double t0_s,
                 const friction::SpeedStep& step, std::span<double> state, int cuts) {
  if (cuts == 0 || !reverses(step)) {
    friction.advance(state, step);
    return;
  }
  // Speeds next to the reversal may have the wrong sign by rounding: there it is zero.
  const double turn = turn_within(motion, t0_s, step);
  const double t1_s = t0_s + step.duration_s;
  const friction::SpeedStep before{step.start_rad_s, motion.speed((t0_s + turn) / 2), 0.0,
                                   turn - t0_s};
  const friction::SpeedStep after{0.0, motion.speed((turn + t1_s) / 2), step.end_rad_s,
                                  t1_s - turn};
  advance_cut(friction, motion, t0_s, before, state, cuts - 1);
  advance_cut(friction, motion, turn, after, state, cuts - 1);
}

}  // namespace

void friction_response(const friction::DynamicFriction& friction, const Motion& motion, double t0_s,
                       double dt_s, std::span<double> state, std::span<double> torque_Nm) {
  require_positive(dt_s, "sampling interval", "s");
  if (state.size() != friction.states()) throw std::invalid_argument("unequal sizes");
  if (torque_Nm.empty()) return;
  constexpr int most_cuts = 3;
  std::array<double, block_steps> end_speed;
  std::array<double, block_steps> middle_speed;
  std::array<friction::SpeedStep, block_steps> step;
  double speed = motion.speed(t0_s);
  torque_Nm[0] = friction.torque_Nm(state, speed);
  const std::span<double> torque_after = torque_Nm.subspan(1);
  for (std::size_t first = 0; first < torque_after.size(); first += block_steps) {
    const std::size_t steps = std::min(block_steps, torque_after.size() - first);
    const double t = t0_s + static_cast<double>(first) * dt_s;
    motion.speeds(t + dt_s, dt_s, std::span(end_speed).first(steps));
    motion.speeds(t + dt_s / 2, dt_s, std::span(middle_speed).first(steps));
    for (std::size_t i = 0; i < steps; ++i) {
      step[i] = {speed, middle_speed[i], end_speed[i], dt_s};
      speed = end_speed[i];
    }
    for (std::size_t i = 0; i < steps;) {
      std::size_t until = i;
      while (until < steps && !reverses(step[until])) ++until;
      friction.respond(state, std::span(step).subspan(i, until - i),
                       torque_after.subspan(first + i, until - i));
      i = until;
      if (i == steps) break;
      advance_cut(friction, motion, t + static_cast<double>(i) * dt_s, step[i], state, most_cuts);
      torque_after[first + i] = friction.torque_Nm(state, step[i].end_rad_s);
      ++i;
    }
  }
}

}  // namespace tribolog::simulate
