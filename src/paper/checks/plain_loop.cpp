#include "paper/checks/plain_loop.h"

#include <cmath>
#include <numbers>

#include "base/present.h"

namespace tribolog::paper {

std::array<double, 6> plain_loop_torques_Nm(const Scenario& scenario) {
  const LuGreFriction::Parameters& p = bristles_of(scenario).parameters();
  const OscillationExperiment& e = present(scenario.oscillation);
  const double g = p.static_Nm / p.bristle_stiffness_Nm_rad;
  const double swing = scenario.gear_ratio * e.amplitude_rad;
  const double top_speed = 2 * std::numbers::pi * e.frequency_Hz * swing;
  const double gravity_Nm = scenario.load.amplitude_Nm() / scenario.gear_ratio;

  // `way` from the middle of the swing, upwards, or from the reversal before.
  const auto torque = [&](double angle, double speed, double z) {
    const double rate = speed - std::abs(speed) * z / g;
    return gravity_Nm * std::cos(angle / scenario.gear_ratio) + p.bristle_stiffness_Nm_rad * z +
           p.bristle_damping_Nms_rad * rate + p.viscous_Nms_rad * speed;
  };
  const auto speed_after = [&](double way) {
    const double angle = swing - way;
    return top_speed * std::sqrt(1 - angle * angle / (swing * swing));
  };
  const double z_C = g * (1 - std::exp(-swing / g));
  const auto dropping = [&](double way) {
    return torque(swing - way, -speed_after(way), -g + (z_C + g) * std::exp(-way / g));
  };
  const double z_D = -g + (z_C + g) * std::exp(-2 * swing / g);
  const auto rising = [&](double way) {
    return torque(way - swing, speed_after(way), g - (g - z_D) * std::exp(-way / g));
  };
  const double way_B = g * std::log((z_C + g) / g);
  // |dz/dt| ~ sqrt(2u - u²) exp(-N u) is largest where N u² - (2N + 1) u + 1 = 0; u: way/swing.
  const double N = swing / g;
  const double half = (2 * N + 1) / (2 * N);
  const double way_F = swing * (half - std::sqrt(half * half - 1 / N));
  return {torque(0, top_speed, 0), dropping(way_B), torque(swing, 0, z_C),
          torque(-swing, 0, z_D),  rising(way_F),   dropping(way_F)};
}

}  // namespace tribolog::paper
