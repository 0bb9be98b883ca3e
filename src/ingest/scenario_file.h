#pragma once
// A scenario to simulate, from a TOML file. Units stand in the keys' names; an angle `x` is given
// either as x_rad or as x_deg, a joint speed as ..._rad_s or ..._deg_s.
//
//   schema = "tribolog-scenario-1", name
//   [robot]       name; serial (optional)
//   [joint]       name, gear_ratio, motor_inertia_kgm2, arm_inertia_kgm2
//   [load]        mass_kg, distance_m, q_peak; gravity_m_s2 = 9.81
//   [surrogate]   distance_m = 0.5 (optional)
//   [friction.presliding]  model = "lugre" and its six parameters (lugre.h)
//   [friction.sliding]     model = "waiboer" and its parameters (waiboer.h)
//   [rough_sweep], [precise_sweep]  from, to, speed; both_directions = true, acceleration = 1
//   rad/s2,
//                 sample_rate_Hz = 1000
//   [oscillation] centre, amplitude, frequency_Hz, cycles; sample_rate_Hz = 1000,
//                 record_bristle = true
//   [constant_speed]  motor_speeds_rad_s, centre, largest_travel, longest_plateau_s, acceleration;
//                 both_directions = true, sample_rate_Hz = 1000
//   [noise]       torque_white_Nm, torque_step_Nm, encoder_counts_per_turn, speed_filter_Hz, seed;
//                 [[noise.ripple]] amplitude_Nm, periods_per_turn, phase (all optional)
//
// Every experiment may be left out, but not all of them.

#include <string>
#include <string_view>

#include "simulate/scenario.h"

namespace tribolog {

/// @throw InputError at file:line:column for whatever is missing, unknown, impossible or misspelt.
Scenario read_scenario(const std::string& path);

/// The same from a text. @param file its name, for messages.
Scenario parse_scenario(std::string_view text, const std::string& file);

}  // namespace tribolog
