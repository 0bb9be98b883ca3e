#include "support/paper_joint.h"

#include <numbers>

namespace tribolog::test {
namespace {

constexpr double degree = std::numbers::pi / 180;

}  // namespace

double true_q_peak_rad() { return -22.23187 * degree; }

friction::LuGreFriction paper_contact() {
  return friction::LuGreFriction({465.42, 0.77080, 0.001, 0.60, 0.88437633, 5.0});
}

friction::WaiboerFriction paper_curve() {
  return friction::WaiboerFriction({0.8844, 5.0, 0.7, 0.12, 0.6, 1e6});
}

simulate::Scenario paper_joint() {
  simulate::Scenario s;
  s.name = "paper's joint";
  s.robot = "FANUC AM100iB";
  s.joint = "J3";
  s.gear_ratio = 100;
  s.motor_inertia_kgm2 = 1e-4;
  const double distance = 0.4;
  const double mass = true_gravity_Nm * s.gear_ratio / (9.81 * distance);
  s.load = joint::GravityLoad(mass, distance, true_q_peak_rad());
  s.arm_inertia_kgm2 = mass * distance * distance;
  s.presliding = std::make_shared<friction::LuGreFriction>(paper_contact());
  s.sliding = std::make_shared<friction::WaiboerFriction>(paper_curve());
  s.rough_sweep =
      simulate::SweepExperiment{-80 * degree, 60 * degree, 2 * degree, true, 1.0, 1000.0};
  s.precise_sweep =
      simulate::SweepExperiment{-23.2 * degree, -21.2 * degree, 0.1 * degree, true, 1.0, 1000.0};
  s.oscillation = simulate::OscillationExperiment{true_q_peak_rad(), 1e-4, 1.0, 5.0, 1000.0, true};
  simulate::ConstantSpeedExperiment runs;
  runs.motor_speeds_rad_s = {1,  1.5, 2,  3,  4,  5.5, 7.5, 10,  13,  17,
                             22, 30,  40, 55, 75, 100, 135, 180, 240, 300};
  runs.centre_rad = true_q_peak_rad();
  runs.largest_travel_rad = 60 * degree;
  runs.longest_plateau_s = 5.0;
  runs.acceleration_rad_s2 = 20.0;
  s.constant_speed = runs;
  return s;
}

simulate::Scenario noisy_paper_joint(std::uint64_t seed) {
  simulate::Scenario s = paper_joint();
  s.noise.torque_white_Nm = 0.02;
  s.noise.torque_step_Nm = 0.005;
  s.noise.encoder_counts_per_turn = 131072;
  s.noise.speed_filter_Hz = 100;
  s.noise.seed = seed;
  s.oscillation->cycles = 10;
  s.oscillation->record_bristle = false;
  return s;
}

}  // namespace tribolog::test
