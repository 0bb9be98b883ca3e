#include "simulate/marched_motion.h"

#include <cmath>
#include <cstddef>
#include <vector>

namespace tribolog::test {

simulate::ForcedMotion marched_motion(const friction::DynamicFriction& friction,
                                      const simulate::ForcedMotionSetup& setup, double step_s,
                                      bool holds_by_itself) {
  std::vector<double> state = friction.unloaded();
  constexpr double next_to_rest_rad_s = 1e-12;
  const double holding_Nm = friction.steady_torque_Nm(next_to_rest_rad_s);
  const auto every = static_cast<std::size_t>(std::lround(setup.sample_s / step_s));
  const auto steps = static_cast<std::size_t>(std::lround(setup.duration_s / step_s));
  double angle = setup.angle_rad;
  double speed = setup.speed_rad_s;
  simulate::ForcedMotion out;
  for (std::size_t i = 0; i <= steps; ++i) {
    const double t = static_cast<double>(i) * step_s;
    const double applied = setup.applied_Nm(t, angle, speed);
    const bool is_held = !holds_by_itself && speed == 0 && std::abs(applied) <= holding_Nm;
    const double torque = is_held ? applied : friction.torque_Nm(state, speed);
    if (i % every == 0) {
      out.t_s.push_back(t);
      out.angle_rad.push_back(angle);
      out.speed_rad_s.push_back(speed);
      out.applied_Nm.push_back(applied);
      out.friction_Nm.push_back(torque);
    }
    if (is_held) continue;
    // Out of rest friction has the direction of the push.
    const double sliding =
        !holds_by_itself && speed == 0 ? std::copysign(holding_Nm, applied) : torque;
    double next = speed + (applied - sliding) / setup.inertia_kgm2 * step_s;
    if (speed * next < 0) next = 0;
    const double middle = (speed + next) / 2;
    friction.advance(state, {speed, middle, next, step_s});
    angle += middle * step_s;
    speed = next;
  }
  return out;
}

}  // namespace tribolog::test
