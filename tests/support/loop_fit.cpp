#include "support/loop_fit.h"

#include <cmath>

#include "method/motion/encoder_resolution.h"
#include "support/paper_joint.h"

namespace tribolog::test {
namespace {

using method::hysteresis::LuGreParameterName;

constexpr double gear_ratio = 100;

}  // namespace

std::vector<joint::Recording> oscillations_of(const simulate::Scenario& scenario) {
  simulate::Scenario s = scenario;
  s.rough_sweep.reset();
  s.precise_sweep.reset();
  s.constant_speed.reset();
  return simulate::simulated_dataset(s).recordings;
}

method::hysteresis::KnownOfLoops contact_alone() {
  method::hysteresis::KnownOfLoops known;
  for (const joint::Effect& one : joint::statable_effects()) known.effects.sizes.state(one, 0);
  return known;
}

method::hysteresis::FittedLuGre fitted_loops(const std::vector<joint::Recording>& oscillations,
                                             const method::hysteresis::KnownOfLoops& known) {
  std::vector<method::motion::OscillationMotion> motions;
  for (const joint::Recording& r : oscillations)
    motions.push_back(*method::motion::fit_oscillation_motion(r));
  std::vector<method::hysteresis::LuGreInput> inputs;
  for (std::size_t k = 0; k < oscillations.size(); ++k) {
    inputs.push_back({&oscillations[k], &motions[k], nullptr,
                      method::motion::angle_step(oscillations[k].q_rad, gear_ratio).step_rad});
  }
  return method::hysteresis::fit_lugre(inputs, gear_ratio, true_q_peak_rad(), {}, known);
}

std::map<method::hysteresis::LuGreParameterName, double> true_parameters(
    const simulate::Scenario& s) {
  const auto& p = dynamic_cast<const friction::LuGreFriction&>(*s.presliding).parameters();
  return {{LuGreParameterName::bristle_stiffness, p.bristle_stiffness_Nm_rad},
          {LuGreParameterName::bristle_damping, p.bristle_damping_Nms_rad},
          {LuGreParameterName::viscous, p.viscous_Nms_rad},
          {LuGreParameterName::static_torque, p.static_Nm},
          {LuGreParameterName::coulomb_torque, p.coulomb_Nm},
          {LuGreParameterName::stribeck_speed, p.stribeck_speed_rad_s},
          {LuGreParameterName::speed_weakening,
           (p.static_Nm - p.coulomb_Nm) / std::pow(p.stribeck_speed_rad_s, 2)},
          {LuGreParameterName::inertia,
           s.motor_inertia_kgm2 + s.arm_inertia_kgm2 / (s.gear_ratio * s.gear_ratio)}};
}

simulate::Scenario at_eight_positions(simulate::Scenario s, double phase_1_rad,
                                      double phase_6_rad) {
  s.noise.ripple = {{0.02, 1, phase_1_rad}, {0.02, 6, phase_6_rad}};
  const auto all = simulate::spread_over_motor_turn(*s.oscillation, 8, s.gear_ratio);
  s.oscillation = all.front();
  s.further_oscillations.assign(all.begin() + 1, all.end());
  return s;
}

}  // namespace tribolog::test
