#pragma once
// A scenario to simulate, from a TOML file. Units stand in the keys' names; an angle `x` is given
// either as x_rad or as x_deg, a joint speed as ..._rad_s or ..._deg_s.
//
//   schema = "tribolog-scenario-1", name
//   [robot]       name; serial (optional)
//                 description (file of the arm, relative to the scenario; robot_file.h; optional)
//   [joint]       name, gear_ratio, motor_inertia_kgm2, arm_inertia_kgm2
//   [load]        mass_kg, distance_m, q_peak; gravity_m_s2 = 9.81
//   [surrogate]   distance_m = 0.5 (optional)
//   [friction]    model = "lugre", or another one of dynamic_friction_models(): drives the
//                 oscillation
//   [friction.presliding]  the contact, by LuGre's six parameters (lugre.h); those of any other
//                 model are matched to it
//   [friction.<model>]     the chosen model's own parameters, named as its by_name() says; each
//                 replaces the matched one, and where all are given, presliding may be left out.
//                 elements = [{stiffness_Nm_rad, share}, ...]
//   [friction.sliding]     drives sweeps and runs: model = "waiboer", "stribeck" or
//                 "threshold_speed" and its parameters, or model = "dynamic" for the model above
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
//
// [[joints]] in place of [joint] are those of a whole robot, one after another in one log: each has
// what stands in [joint], and tables of its own, [joints.load] for example, as a robot's manifest
// (robot_joints.h).

#include <string>
#include <string_view>
#include <vector>

#include "simulate/scenario.h"

namespace tribolog::ingest::manifest {

/// @throw InputError at file:line:column for whatever is missing, unknown, impossible or misspelt.
simulate::Scenario read_scenario(const std::string& path);

/// One for each joint of a robot; empty: it is a single joint's.
/// @throw InputError as read_scenario().
std::vector<simulate::Scenario> read_robot_scenario(const std::string& path);

/// The same from a text; the robot's description is named but not read.
/// @param file its name, for messages.
simulate::Scenario parse_scenario(std::string_view text, const std::string& file);

}  // namespace tribolog::ingest::manifest
