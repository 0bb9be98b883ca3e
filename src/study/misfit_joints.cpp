// The joints of the misfit study.

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "joint/degrees.h"
#include "simulate/simulate_joint.h"
#include "study/misfit.h"
#include "study/misfit_scenario.h"

namespace tribolog::study {
namespace {

using simulate::Scenario;

/// A joint from the numbers that tell it from others; its experiments fit them.
struct JointSketch {
  double gear_ratio;
  double motor_inertia_kgm2;
  double mass_kg, distance_m, q_peak_deg;
  LuGreParameters friction;
  double rate_Hz;
  double white_Nm, torque_step_Nm, encoder_counts;
  double fastest_rad_s;  ///< Motor side.
};

Scenario sketched(const JointSketch& j) {
  Scenario s;
  s.name = "joint of the misfit study";
  s.robot = s.serial = "simulated";
  s.joint = std::string("1");  // GCC 12 warns of an overlap where the literal is assigned
  s.log.keeps_friction_secret = true;
  s.gear_ratio = j.gear_ratio;
  s.motor_inertia_kgm2 = j.motor_inertia_kgm2;
  s.arm_inertia_kgm2 = j.mass_kg * j.distance_m * j.distance_m;
  s.load = joint::GravityLoad(j.mass_kg, j.distance_m, j.q_peak_deg * joint::rad_per_degree);
  set_lugre(s, j.friction);
  const double n = j.gear_ratio;
  const double q = s.load.q_peak_rad();
  const double range = 70 * joint::rad_per_degree;
  simulate::SweepExperiment sweep{q - range, q + range * 0.9, 0};
  sweep.speed_rad_s = 4 * joint::rad_per_degree;
  sweep.sample_rate_Hz = j.rate_Hz / 4;
  s.rough_sweep = sweep;
  const double bristle = j.friction.static_Nm / j.friction.bristle_stiffness_Nm_rad;
  simulate::OscillationExperiment loop{q, 5 * bristle / n, 1, 10, j.rate_Hz, false};
  auto loops = simulate::spread_over_motor_turn(loop, n > 1 ? 4 : 1, n);
  // A faster, larger one shows how friction falls with speed.
  simulate::OscillationExperiment large = loop;
  large.amplitude_rad *= 20;
  loops.push_back(large);
  s.oscillation = loops.front();
  s.further_oscillations.assign(loops.begin() + 1, loops.end());
  simulate::ConstantSpeedExperiment runs;
  constexpr int speeds = 12;
  const double slowest = std::min(0.15 * j.friction.stribeck_speed_rad_s, j.fastest_rad_s / 100);
  for (int k = 0; k < speeds; ++k) {
    runs.motor_speeds_rad_s.push_back(
        slowest * std::pow(j.fastest_rad_s / slowest, static_cast<double>(k) / (speeds - 1)));
  }
  runs.centre_rad = q;
  runs.largest_travel_rad = range;
  runs.longest_plateau_s = 3;
  runs.acceleration_rad_s2 = 20;
  runs.sample_rate_Hz = j.rate_Hz / 2;
  s.constant_speed = runs;
  simulate::BreakAwayExperiment ramps;
  ramps.centre_rad = q;
  ramps.largest_torque_Nm = 1.6 * j.friction.static_Nm;
  ramps.rate_Nm_s = ramps.largest_torque_Nm / 3;
  ramps.largest_travel_rad = 20 * bristle / n;
  ramps.repeats = 3;
  ramps.sample_rate_Hz = j.rate_Hz;
  s.break_away = ramps;
  s.noise.torque_white_Nm = j.white_Nm;
  s.noise.torque_step_Nm = j.torque_step_Nm;
  s.noise.encoder_counts_per_turn = j.encoder_counts;
  s.noise.speed_filter_Hz = 100;
  return s;
}

}  // namespace

std::vector<MisfitJoint> misfit_joints() {
  return {
      {"geared_arm", sketched({100,
                               1e-4,
                               98.96,
                               0.4,
                               -22.23187,
                               {465.42, 0.7708, 0.001, 0.60, 0.88437633, 5},
                               1000,
                               0.02,
                               0.005,
                               131072,
                               300})},
      {"cobot_joint", sketched({101,
                                2.5e-4,
                                11.2,
                                0.45,
                                8.0,
                                {90, 0.12, 4e-4, 0.12, 0.16, 3},
                                500,
                                0.004,
                                0.001,
                                524288,
                                150})},
      {"direct_drive", sketched({1,
                                 0.05,
                                 12,
                                 0.32,
                                 -85.0,
                                 {3.0e4, 120, 3.0, 9.5, 11.5, 0.06},
                                 500,
                                 0.05,
                                 0.01,
                                 4194304,
                                 1.6})},
      {"small_servo", sketched({30,
                                1.2e-5,
                                0.49,
                                0.1,
                                31.0,
                                {1.1, 3e-3, 8e-5, 1.6e-3, 2.2e-3, 4},
                                250,
                                5e-5,
                                1e-5,
                                131072,
                                150})},
      // A big axis, a light wrist of much friction, and a gantry's fast axis with little.
      {"heavy_axis", sketched({185,
                               6e-3,
                               420,
                               0.9,
                               -64.0,
                               {2400, 3.0, 9e-3, 3.2, 4.4, 6},
                               250,
                               0.08,
                               0.02,
                               65536,
                               200})},
      {"harmonic_wrist", sketched({160,
                                   3e-5,
                                   3.1,
                                   0.11,
                                   47.0,
                                   {42, 0.03, 3e-5, 0.031, 0.042, 8},
                                   1000,
                                   4e-4,
                                   1e-4,
                                   1048576,
                                   400})},
      {"belt_drive", sketched({5,
                               4e-4,
                               2.4,
                               0.28,
                               -120.0,
                               {95, 0.08, 9e-4, 0.055, 0.066, 2},
                               2000,
                               3e-3,
                               5e-4,
                               1048576,
                               60})},
  };
}

}  // namespace tribolog::study
