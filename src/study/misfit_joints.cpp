// The joints of the misfit study.

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "joint/degrees.h"
#include "simulate/simulate_joint.h"
#include "study/joint_sketch.h"
#include "study/misfit.h"

namespace tribolog::study {

using simulate::Scenario;

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

std::vector<NamedSketch> joint_sketches() {
  return {
      {"geared_arm",
       {.gear_ratio = 100,
        .motor_inertia_kgm2 = 1e-4,
        .mass_kg = 98.96,
        .distance_m = 0.4,
        .q_peak_deg = -22.23187,
        .friction = {.bristle_stiffness_Nm_rad = 465.42,
                     .bristle_damping_Nms_rad = 0.7708,
                     .viscous_Nms_rad = 0.001,
                     .coulomb_Nm = 0.60,
                     .static_Nm = 0.88437633,
                     .stribeck_speed_rad_s = 5},
        .rate_Hz = 1000,
        .white_Nm = 0.02,
        .torque_step_Nm = 0.005,
        .encoder_counts = 131072,
        .fastest_rad_s = 300}},
      {"cobot_joint",
       {.gear_ratio = 101,
        .motor_inertia_kgm2 = 2.5e-4,
        .mass_kg = 11.2,
        .distance_m = 0.45,
        .q_peak_deg = 8.0,
        .friction = {.bristle_stiffness_Nm_rad = 90,
                     .bristle_damping_Nms_rad = 0.12,
                     .viscous_Nms_rad = 4e-4,
                     .coulomb_Nm = 0.12,
                     .static_Nm = 0.16,
                     .stribeck_speed_rad_s = 3},
        .rate_Hz = 500,
        .white_Nm = 0.004,
        .torque_step_Nm = 0.001,
        .encoder_counts = 524288,
        .fastest_rad_s = 150}},
      {"direct_drive",
       {.gear_ratio = 1,
        .motor_inertia_kgm2 = 0.05,
        .mass_kg = 12,
        .distance_m = 0.32,
        .q_peak_deg = -85.0,
        .friction = {.bristle_stiffness_Nm_rad = 3.0e4,
                     .bristle_damping_Nms_rad = 120,
                     .viscous_Nms_rad = 3.0,
                     .coulomb_Nm = 9.5,
                     .static_Nm = 11.5,
                     .stribeck_speed_rad_s = 0.06},
        .rate_Hz = 500,
        .white_Nm = 0.05,
        .torque_step_Nm = 0.01,
        .encoder_counts = 4194304,
        .fastest_rad_s = 1.6}},
      {"small_servo",
       {.gear_ratio = 30,
        .motor_inertia_kgm2 = 1.2e-5,
        .mass_kg = 0.49,
        .distance_m = 0.1,
        .q_peak_deg = 31.0,
        .friction = {.bristle_stiffness_Nm_rad = 1.1,
                     .bristle_damping_Nms_rad = 3e-3,
                     .viscous_Nms_rad = 8e-5,
                     .coulomb_Nm = 1.6e-3,
                     .static_Nm = 2.2e-3,
                     .stribeck_speed_rad_s = 4},
        .rate_Hz = 250,
        .white_Nm = 5e-5,
        .torque_step_Nm = 1e-5,
        .encoder_counts = 131072,
        .fastest_rad_s = 150}},
      // A big axis, a light wrist of much friction, and a gantry's fast axis with little.
      {"heavy_axis",
       {.gear_ratio = 185,
        .motor_inertia_kgm2 = 6e-3,
        .mass_kg = 420,
        .distance_m = 0.9,
        .q_peak_deg = -64.0,
        .friction = {.bristle_stiffness_Nm_rad = 2400,
                     .bristle_damping_Nms_rad = 3.0,
                     .viscous_Nms_rad = 9e-3,
                     .coulomb_Nm = 3.2,
                     .static_Nm = 4.4,
                     .stribeck_speed_rad_s = 6},
        .rate_Hz = 250,
        .white_Nm = 0.08,
        .torque_step_Nm = 0.02,
        .encoder_counts = 65536,
        .fastest_rad_s = 200}},
      {"harmonic_wrist",
       {.gear_ratio = 160,
        .motor_inertia_kgm2 = 3e-5,
        .mass_kg = 3.1,
        .distance_m = 0.11,
        .q_peak_deg = 47.0,
        .friction = {.bristle_stiffness_Nm_rad = 42,
                     .bristle_damping_Nms_rad = 0.03,
                     .viscous_Nms_rad = 3e-5,
                     .coulomb_Nm = 0.031,
                     .static_Nm = 0.042,
                     .stribeck_speed_rad_s = 8},
        .rate_Hz = 1000,
        .white_Nm = 4e-4,
        .torque_step_Nm = 1e-4,
        .encoder_counts = 1048576,
        .fastest_rad_s = 400}},
      {"belt_drive",
       {.gear_ratio = 5,
        .motor_inertia_kgm2 = 4e-4,
        .mass_kg = 2.4,
        .distance_m = 0.28,
        .q_peak_deg = -120.0,
        .friction = {.bristle_stiffness_Nm_rad = 95,
                     .bristle_damping_Nms_rad = 0.08,
                     .viscous_Nms_rad = 9e-4,
                     .coulomb_Nm = 0.055,
                     .static_Nm = 0.066,
                     .stribeck_speed_rad_s = 2},
        .rate_Hz = 2000,
        .white_Nm = 3e-3,
        .torque_step_Nm = 5e-4,
        .encoder_counts = 1048576,
        .fastest_rad_s = 60}},
      // A shoulder, a legged robot's planetary drive, a pan-tilt head, a press's slow axis and a
      // light gripper's wrist.
      {"shoulder",
       {.gear_ratio = 121,
        .motor_inertia_kgm2 = 9e-4,
        .mass_kg = 31,
        .distance_m = 0.62,
        .q_peak_deg = -5.0,
        .friction = {.bristle_stiffness_Nm_rad = 260,
                     .bristle_damping_Nms_rad = 0.3,
                     .viscous_Nms_rad = 1.6e-3,
                     .coulomb_Nm = 0.41,
                     .static_Nm = 0.52,
                     .stribeck_speed_rad_s = 7},
        .rate_Hz = 500,
        .white_Nm = 0.012,
        .torque_step_Nm = 0.003,
        .encoder_counts = 131072,
        .fastest_rad_s = 220}},
      {"planetary_leg",
       {.gear_ratio = 9,
        .motor_inertia_kgm2 = 6e-5,
        .mass_kg = 1.7,
        .distance_m = 0.19,
        .q_peak_deg = 62.0,
        .friction = {.bristle_stiffness_Nm_rad = 28,
                     .bristle_damping_Nms_rad = 0.02,
                     .viscous_Nms_rad = 1.1e-4,
                     .coulomb_Nm = 0.021,
                     .static_Nm = 0.027,
                     .stribeck_speed_rad_s = 1.5},
        .rate_Hz = 1000,
        .white_Nm = 1.2e-3,
        .torque_step_Nm = 2e-4,
        .encoder_counts = 131072,
        .fastest_rad_s = 90}},
      {"pan_tilt",
       {.gear_ratio = 60,
        .motor_inertia_kgm2 = 8e-6,
        .mass_kg = 0.9,
        .distance_m = 0.12,
        .q_peak_deg = -140.0,
        .friction = {.bristle_stiffness_Nm_rad = 2.6,
                     .bristle_damping_Nms_rad = 4e-3,
                     .viscous_Nms_rad = 2.5e-5,
                     .coulomb_Nm = 4.2e-3,
                     .static_Nm = 5.6e-3,
                     .stribeck_speed_rad_s = 6},
        .rate_Hz = 250,
        .white_Nm = 1.5e-4,
        .torque_step_Nm = 4e-5,
        .encoder_counts = 65536,
        .fastest_rad_s = 180}},
      {"slow_press",
       {.gear_ratio = 310,
        .motor_inertia_kgm2 = 2.2e-3,
        .mass_kg = 640,
        .distance_m = 0.55,
        .q_peak_deg = 20.0,
        .friction = {.bristle_stiffness_Nm_rad = 1500,
                     .bristle_damping_Nms_rad = 2.5,
                     .viscous_Nms_rad = 4e-3,
                     .coulomb_Nm = 2.1,
                     .static_Nm = 3.0,
                     .stribeck_speed_rad_s = 10},
        .rate_Hz = 500,
        .white_Nm = 0.05,
        .torque_step_Nm = 0.01,
        .encoder_counts = 262144,
        .fastest_rad_s = 300}},
      {"gripper_wrist",
       {.gear_ratio = 50,
        .motor_inertia_kgm2 = 1.5e-5,
        .mass_kg = 1.4,
        .distance_m = 0.16,
        .q_peak_deg = 97.0,
        .friction = {.bristle_stiffness_Nm_rad = 9,
                     .bristle_damping_Nms_rad = 0.012,
                     .viscous_Nms_rad = 5e-5,
                     .coulomb_Nm = 0.011,
                     .static_Nm = 0.014,
                     .stribeck_speed_rad_s = 4},
        .rate_Hz = 1000,
        .white_Nm = 3e-4,
        .torque_step_Nm = 8e-5,
        .encoder_counts = 262144,
        .fastest_rad_s = 250}},
  };
}

std::vector<MisfitJoint> misfit_joints() {
  std::vector<MisfitJoint> joints;
  for (const NamedSketch& one : joint_sketches()) joints.push_back({one.key, sketched(one.sketch)});
  return joints;
}

}  // namespace tribolog::study
