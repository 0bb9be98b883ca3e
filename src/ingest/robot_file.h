#pragma once
// A robot's description from a TOML file. Units stand in the keys' names; an angle `x` is given
// either as x_rad or as x_deg. The base's frame: x forwards, y to the left, z upwards.
//
//   schema = "tribolog-robot-1", name, dimensions = "approximate" or "exact"
//   flange_m      [x, y, z] in the frame of the last joint
//   [[joints]]    from the base on: name, axis [x, y, z], offset_m [x, y, z] from the joint before;
//                 lowest, highest; portrait = 0 (angle in the picture of the robot),
//                 held_at = 0 (angle while another joint is tested);
//                 radius_m, end_radius_m of the link, bar_thickness_m (0: a round link),
//                 drum_radius_m, drum_length_m of the joint's housing (all optional);
//                 bends_m [x, y, z, x, y, z ...] corners of the link (optional)
//   [under_test]  joint (its name), lowest, highest (range of motion during the test)
//   [load]        mass_kg, distance_m, q_peak; gravity_m_s2 = 9.81
//   [surrogate]   distance_m = 0.5 (optional)
//
// The tested joint's axis is horizontal and points so that a positive turn raises the load.

#include <string>
#include <string_view>

#include "robot/robot_description.h"

namespace tribolog {

/// @throw InputError at file:line:column for whatever is missing, unknown, impossible or misspelt.
RobotDescription read_robot(const std::string& path);

/// The same from a text. @param file its name, for messages.
RobotDescription parse_robot(std::string_view text, const std::string& file);

}  // namespace tribolog
