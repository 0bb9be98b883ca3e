// The disturbances of the misfit study, in three sizes each.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "friction/catalogue.h"
#include "joint/degrees.h"
#include "simulate/scenario.h"
#include "study/misfit.h"
#include "study/misfit_scenario.h"

namespace tribolog::study {
namespace {

using simulate::Scenario;

double friction_of(const Scenario& s) { return std::abs(s.presliding->steady_torque_Nm(1e-9)); }

void set_contact(Scenario& s, const char* model) {
  const LuGreParameters& p = lugre_of(s);
  s.presliding = friction::dynamic_friction_model(model).matched(
      {p.bristle_stiffness_Nm_rad, p.bristle_damping_Nms_rad, p.viscous_Nms_rad, p.coulomb_Nm,
       p.static_Nm, p.stribeck_speed_rad_s});
}

void scale_amplitude(Scenario& s, double factor) {
  if (s.oscillation) s.oscillation->amplitude_rad *= factor;
  for (simulate::OscillationExperiment& e : s.further_oscillations) e.amplitude_rad *= factor;
}

/// Loops and ramps at one motor angle, that of the largest friction: from there nothing averages.
void record_at_largest_friction(Scenario& s) {
  s.effects.phase_of_motor_angle_rad =
      -s.effects.periods_per_motor_turn * s.gear_ratio * s.break_away->centre_rad;
  const double here = s.oscillation->centre_rad;
  std::erase_if(s.further_oscillations,
                [&](const simulate::OscillationExperiment& e) { return e.centre_rad != here; });
}

std::vector<Disturbance> all_disturbances() {
  return {
      {"torque_delay",
       {0.0005, 0.002, 0.005},
       [](Scenario& s, double x) { s.noise.effects.torque_delay_s = x; },
       {"effect.lag"}},
      {"angle_delay",
       {0.0005, 0.002, 0.005},
       [](Scenario& s, double x) { s.noise.effects.torque_delay_s = -x; },
       {"effect.lag"}},
      {"torque_filter",
       {100, 50, 20},
       [](Scenario& s, double x) { s.noise.effects.torque_filter_Hz = x; },
       {"effect.lag"}},
      {"torque_mean",
       {0.005, 0.02, 0.05},
       [](Scenario& s, double x) { s.noise.effects.torque_mean_s = x; },
       {"effect.lag"}},
      {"elasto_plastic_contact",
       {1, 2, 0.7},
       [](Scenario& s, double x) {
         set_contact(s, "elasto_plastic");
         scale_amplitude(s, x);
       },
       {"cause.other_contact"}},
      {"maxwell_slip_contact",
       {1, 2, 0.7},
       [](Scenario& s, double x) {
         set_contact(s, "gms");
         scale_amplitude(s, x);
       },
       {"cause.other_contact"}},
      {"leuven_contact",
       {1, 2, 0.7},
       [](Scenario& s, double x) {
         set_contact(s, "leuven");
         scale_amplitude(s, x);
       },
       {"cause.other_contact"}},
      {"gear_loss",
       {0.005, 0.02, 0.05},
       [](Scenario& s, double x) { s.effects.gear_loss = x; },
       {"effect.load"}},
      {"load_friction",
       {0.01, 0.03, 0.1},
       [](Scenario& s, double x) { s.effects.load_friction = x; },
       {"effect.load"}},
      {"direction_asymmetry",
       {0.01, 0.05, 0.2},
       [](Scenario& s, double x) { s.effects.direction_asymmetry = x; },
       {"effect.offset", "effect.asymmetry", "cause.asymmetry"}},
      {"torque_offset",
       {0.001, 0.005, 0.02},
       [](Scenario& s, double x) { s.effects.torque_offset_Nm = x * motor_gravity(s); },
       {"effect.offset", "cause.offset", "cause.asymmetry"}},
      {"offset_drift",
       {0.002, 0.01, 0.03},
       [](Scenario& s, double x) { s.effects.offset_drift_Nm = x * motor_gravity(s); },
       {"effect.offset_drift"}},
      {"warm_up",
       {0.05, 0.1, 0.2},
       [](Scenario& s, double x) { s.effects.warm_up = x; },
       {"effect.drift"}},
      {"friction_by_angle",
       {0.02, 0.05, 0.2},
       [](Scenario& s, double x) { s.effects.friction_by_angle = x; },
       {"effect.position", "effect.load"}},
      {"friction_by_motor_angle",
       {0.02, 0.05, 0.1},
       [](Scenario& s, double x) {
         s.effects.friction_by_motor_angle = x;
         record_at_largest_friction(s);
       },
       {"cause.friction_by_motor_angle", "effect.position"}},
      {"gear_windup",
       {0.1, 0.5, 1},
       [](Scenario& s, double x) { s.effects.gear_windup_rad = x * joint::rad_per_degree; },
       {"effect.lag", "effect.harmonics"}},
      {"spring",
       {0.002, 0.01, 0.05},
       [](Scenario& s, double x) { s.effects.spring_Nm_rad = x * motor_gravity(s); },
       {"effect.hoses", "effect.harmonics", "effect.smooth_over_angle"}},
      {"twice_the_angle",
       {0.002, 0.01, 0.05},
       [](Scenario& s, double x) { s.effects.twice_the_angle_Nm = x * motor_gravity(s); },
       {"effect.harmonics", "effect.smooth_over_angle", "effect.offset",
        "effect.torque_nonlinear"}},
      {"late_stribeck_dip",
       {2, 5, 10},
       [](Scenario& s, double x) {
         LuGreParameters p = lugre_of(s);
         const double slowest = s.constant_speed->motor_speeds_rad_s.front();
         p.stribeck_speed_rad_s *= x;
         set_lugre(s, p);
         s.constant_speed->motor_speeds_rad_s.front() = slowest;
       },
       {"cause.stribeck", "model.law_bends", "effect.law_misfit"}},
      {"stribeck_power",
       {1, 1.5, 3},
       [](Scenario& s, double x) {
         LuGreParameters p = lugre_of(s);
         p.stribeck_power = x;
         set_lugre(s, p);
       },
       {"cause.stribeck_exponent", "cause.stribeck"}},
      {"damping_fall",
       {1, 0.6, 0.3},  // of the loops' peak speed
       [](Scenario& s, double x) {
         LuGreParameters p = lugre_of(s);
         p.damping_speed_rad_s = x * s.gear_ratio * 2 * std::numbers::pi *
                                 s.oscillation->frequency_Hz * s.oscillation->amplitude_rad;
         set_lugre(s, p);
       },
       {"cause.damping_falls", "cause.other_contact"}},
      {"friction_taken_off",
       {0.1, 0.4, 0.8},
       [](Scenario& s, double x) {
         s.effects.taken_off = x;
         s.effects.taken_off_from_rad_s = 0.1 * lugre_of(s).stribeck_speed_rad_s;
       },
       {"cause.runs_against_ramps", "cause.runs_against_loops", "cause.friction_taken_off"}},
      {"convex_viscous",
       {1.2, 1.5, 1.8},
       [](Scenario& s, double x) {
         s.effects.viscous_exponent = x;
         s.effects.bent_viscous_Nms_rad = lugre_of(s).viscous_Nms_rad;
         s.effects.bent_viscous_rad_s = s.constant_speed->motor_speeds_rad_s.back();
       },
       {"model.law_bends"}},
      {"second_harmonic",
       {0.01, 0.03, 0.1},
       [](Scenario& s, double x) { s.effects.second_harmonic = x; },
       {"cause.motion"}},
      {"third_harmonic",
       {0.01, 0.03, 0.1},
       [](Scenario& s, double x) { s.effects.third_harmonic = x; },
       {"cause.motion"}},
      {"coloured_noise",
       {1, 3, 10},
       [](Scenario& s, double x) {
         s.noise.effects.coloured_Nm = x * s.noise.torque_white_Nm;
         s.noise.effects.coloured_time_s = 0.1;
       },
       {"cause.coloured_noise"}},
      {"ripple",
       {0.003, 0.01, 0.03},
       [](Scenario& s, double x) {
         const double a = x * motor_gravity(s);
         s.noise.ripple = {{a, 1, 0}, {a, 6, 0}};
       },
       {"cause.ripple", "check.torque_ripple", "positions."}},
      {"vibration",
       {0.003, 0.01, 0.03},
       [](Scenario& s, double x) {
         s.noise.effects.vibration_Nm = x * motor_gravity(s);
         s.noise.effects.vibration_Hz = 7.3;
       },
       {"cause.vibration"}},
      {"other_joint_moves",
       {0.01, 0.05, 0.2},
       [](Scenario& s, double x) {
         s.noise.effects.neighbour_Nm = x * motor_gravity(s);
         s.noise.effects.neighbour_Hz = 0.13;
       },
       {"cause.other_joint", "effect.offset_drift", "effect.drift", "cause.vibration"}},
      {"torque_constant",
       {1.02, 1.1, 1.5},
       [](Scenario& s, double x) { s.noise.effects.torque_scale = x; },
       {"budget."},
       {},
       true},
      {"torque_saturates",
       {0.003, 0.01, 0.04},
       [](Scenario& s, double x) {
         s.noise.effects.saturation_per_Nm2 = x / std::pow(motor_gravity(s), 2);
       },
       {"effect.torque_nonlinear", "effect.load"}},
      {"torque_grows_out_of_proportion",
       {0.005, 0.02, 0.05},
       [](Scenario& s, double x) { s.noise.effects.saturation_per_Nm = x / motor_gravity(s); },
       {"effect.torque_nonlinear", "effect.load"}},
      {"dead_zone",
       {0.003, 0.01, 0.03},
       [](Scenario& s, double x) { s.noise.effects.dead_zone_Nm = x * motor_gravity(s); },
       {"effect.torque_nonlinear", "effect.offset", "cause.offset"}},
      {"torque_limit",
       {0.98, 0.9, 0.8},
       [](Scenario& s, double x) {
         s.noise.effects.torque_limit_Nm = x * (motor_gravity(s) + friction_of(s));
       },
       {"check.torque_saturation"}},
      {"torque_outliers",
       {0.05, 0.5, 5},
       [](Scenario& s, double x) {
         s.noise.effects.outlier_percent = x;
         s.noise.effects.outlier_Nm = 5 * friction_of(s);
       },
       {"cause.outliers", "check.torque_outliers"}},
      {"torque_stuck",
       {1, 5, 20},
       [](Scenario& s, double x) { s.noise.effects.held_percent = x; },
       {"check.torque_alive", "check.torque_held"}},
      {"torque_dead",
       {10, 40, 100},
       [](Scenario& s, double x) { s.noise.effects.dead_percent = x; },
       {"check.torque_alive"}},
      {"torque_step",
       {0.05, 0.2, 0.5},
       [](Scenario& s, double x) { s.noise.torque_step_Nm = x * friction_of(s); },
       {"check.torque_step"}},
      {"coarse_encoder",
       {20, 8, 3},
       [](Scenario& s, double x) {
         const LuGreParameters& p = lugre_of(s);
         const double bristle = p.static_Nm / p.bristle_stiffness_Nm_rad;
         s.noise.encoder_counts_per_turn = 2 * std::numbers::pi / (bristle / x);
       },
       {"check.encoder_step"}},
      {"angle_jumps",
       {0.1, 0.3, 1},
       [](Scenario& s, double x) { s.noise.effects.jump_rad = x * joint::rad_per_degree; },
       {"check.angle_jumps"}},
      {"homed_anew",
       {0.2, 0.5, 2},
       [](Scenario& s, double x) { s.noise.effects.homed_anew_rad = x * joint::rad_per_degree; },
       {"effect.homing", "effect.peak_drift", "check.oscillation_at_peak"}},
      {"speed_scale",
       {0.9, 0.5, 2},
       [](Scenario& s, double x) { s.noise.effects.speed_scale = x; },
       {"check.speed_scale"}},
      {"small_oscillation",
       {0.3, 0.15, 0.05},
       [](Scenario& s, double x) {
         scale_amplitude(s, x);
         s.further_oscillations.pop_back();
         s.break_away.reset();
       },
       {"check.oscillation_slides", "lugre."}},
      {"one_direction",
       {1, 2, 3},
       [](Scenario& s, double x) {
         if (x != 2) s.constant_speed->both_directions = false;
         if (x != 1) s.rough_sweep->both_directions = false;
       },
       {"check.run_directions", "check.sweep_directions"}},
      {"few_speeds_below_dip",
       {1, 2, 3},
       [](Scenario& s, double x) {
         auto& speeds = s.constant_speed->motor_speeds_rad_s;
         speeds.erase(speeds.begin(), speeds.begin() + static_cast<std::ptrdiff_t>(2 * x));
       },
       {"cause.stribeck", "model.law_bends"}},
      {"jittered_clock",
       {0.0002, 0.001, 0.003},
       [](Scenario& s, double x) { s.noise.clock_jitter_s = x; },
       {"cause.false_stamps", "check.clock_jitter"}},
      {"no_gravity",
       {0.05, 0.01, 0.001},
       [](Scenario& s, double x) {
         s.load = joint::GravityLoad(x * friction_of(s) * s.gear_ratio / (9.81 * 0.1), 0.1,
                                     s.load.q_peak_rad());
       },
       {"cause.no_gravity"}},
      {"coulomb_model_added",
       {0.04, 0.2, 0.5},
       [](Scenario& s, double x) {
         const LuGreParameters& p = lugre_of(s);
         s.noise.effects.coulomb_model_Nm = x * p.coulomb_Nm;
         s.noise.effects.coulomb_model_from_rad_s = 0.1 * p.stribeck_speed_rad_s / s.gear_ratio;
       },
       {"cause.runs_against_ramps", "cause.runs_against_loops"}},
      {"loop_torque_scale",
       {1.02, 0.95, 1.2},
       [](Scenario& s, double x) { s.noise.effects.scale_of_loops = x; },
       {"cause.scale_of_loops", "cause.loops_against_ramps"}},
      {"run_torque_scale",
       {1.005, 0.98, 1.1},
       [](Scenario& s, double x) { s.noise.effects.scale_of_runs = x; },
       {"effect.gain_of_runs"}},
      {"uneven_gear_stiffness",
       {0.1, 0.5, 1},
       [](Scenario& s, double x) {
         s.effects.gear_windup_rad = x * joint::rad_per_degree;
         s.effects.uneven_windup = 0.5;
       },
       {"effect.harmonics"}},
      {"resonant_filter",
       {100, 50, 20},
       [](Scenario& s, double x) { s.noise.effects.resonance_Hz = x; },
       {"effect.lag"}},
      // The part with one period in a turn is another gravity: the angle is off by that, unseen.
      {"angle_crosstalk",
       {0.001, 0.005, 0.02},
       [](Scenario& s, double x) {
         s.noise.effects.crosstalk_Nm = x * motor_gravity(s);
         s.noise.effects.crosstalk_zero_rad = s.load.q_peak_rad();
       },
       {"cause.course_of_angle", "effect.harmonics", "effect.smooth_over_angle"}},
      {"touch",
       {0.01, 0.05, 0.2},
       [](Scenario& s, double x) { s.noise.effects.touch_Nm = x * motor_gravity(s); },
       {"model.recordings_unlike", "model.recordings_left_out", "model.cells_far_off"}},
      {"tool_changed",
       {0.01, 0.03, 0.1},
       [](Scenario& s, double x) { s.effects.tool_gravity = x; },
       {"effect.tool", "effect.gain_of_runs"}},
      {"held_messages",
       {1, 5, 20},
       [](Scenario& s, double x) { s.noise.effects.repeated_percent = x; },
       {"check.torque_alive", "check.torque_held"}},
      {"foreign_recording",
       {1.2, 2, 5},
       [](Scenario& s, double x) {
         s.effects.foreign_run = s.constant_speed->motor_speeds_rad_s.size() / 2;
         s.effects.foreign_friction = x;
       },
       {"model.recordings_unlike", "model.recordings_left_out"}},
      {"gravity_left_out",
       {0.3, 0.9, 1},
       [](Scenario& s, double x) { s.effects.gravity_left_out = x; },
       {"cause.no_gravity"}},
      {"tare_between",
       {0.002, 0.01, 0.05},
       [](Scenario& s, double x) { s.noise.effects.tare_Nm = x * motor_gravity(s); },
       {"effect.tare", "effect.offset_drift"}},
      {"mirrored",
       {1, 2, 3},
       [](Scenario& s, double x) {
         s.noise.effects.mirrored_angle = x != 2;
         s.noise.effects.mirrored_torque = x != 1;
       },
       {"check.friction_dissipates"},
       3},
  };
}

/// All of a sampling rate.
void sample_at(Scenario& s, double rate_Hz) {
  for (auto* sweep : {&s.rough_sweep, &s.precise_sweep}) {
    if (*sweep) (*sweep)->sample_rate_Hz = rate_Hz;
  }
  if (s.oscillation) s.oscillation->sample_rate_Hz = rate_Hz;
  for (auto& oscillation : s.further_oscillations) oscillation.sample_rate_Hz = rate_Hz;
  if (s.constant_speed) s.constant_speed->sample_rate_Hz = rate_Hz;
  if (s.break_away) s.break_away->sample_rate_Hz = rate_Hz;
}

void leave_a_sweep_alone(Scenario& s) {
  s.precise_sweep.reset();
  s.oscillation.reset();
  s.further_oscillations.clear();
  s.constant_speed.reset();
  s.break_away.reset();
}

/// Nothing is wrong with such logs: there is nothing to name.
Disturbance lack(const std::string& key, const std::function<void(Scenario&)>& lay) {
  return {key, {1}, [lay](Scenario& s, double) { lay(s); }, {}, 1};
}

std::vector<Disturbance> all_lacks() {
  return {
      lack("one_sweep", leave_a_sweep_alone),
      lack("sweep_and_three_runs",
           [](Scenario& s) {
             const auto runs = s.constant_speed;
             leave_a_sweep_alone(s);
             s.constant_speed = runs;
             auto& speeds = s.constant_speed->motor_speeds_rad_s;
             speeds = {speeds.front(), speeds[speeds.size() / 2], speeds.back()};
           }),
      lack("three_cycles",
           [](Scenario& s) {
             s.oscillation->cycles = 3;
             for (auto& oscillation : s.further_oscillations) oscillation.cycles = 3;
           }),
      lack("rate_100_Hz", [](Scenario& s) { sample_at(s, 100); }),
      lack("encoder_12_bits", [](Scenario& s) { s.noise.encoder_counts_per_turn = 4096; }),
      lack("torque_12_bits",
           [](Scenario& s) {
             s.noise.torque_step_Nm = 2 * (motor_gravity(s) + 2 * friction_of(s)) / 4096;
           }),
      lack("one_direction",
           [](Scenario& s) {
             s.constant_speed->both_directions = false;
             s.rough_sweep->both_directions = false;
           }),
  };
}

}  // namespace

const std::vector<Disturbance>& lacks() {
  static const std::vector<Disturbance> all = all_lacks();
  return all;
}

const std::vector<Disturbance>& disturbances() {
  static const std::vector<Disturbance> all = all_disturbances();
  return all;
}

}  // namespace tribolog::study
