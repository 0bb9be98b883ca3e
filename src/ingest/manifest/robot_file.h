#pragma once
// A robot's description from a TOML file. Units stand in the keys' names; an angle `x` is given
// either as x_rad or as x_deg. The base's frame: x forwards, y to the left, z upwards.
//
//   schema = "tribolog-robot-1", name, dimensions = "approximate" or "exact"
//   flange_m      [x, y, z] in the frame of the last joint [m]
//   [[joints]]    from the base on: name, axis [x, y, z], offset_m [x, y, z] from the joint before;
//                 lowest, highest (range of motion); portrait (angle in the picture of the robot)
//                 and held_at (angle while another joint is tested), else 0 or, where the range of
//                 motion leaves 0 out, its end that is nearest;
//                 radius_m, end_radius_m of the link, bar_thickness_m (0: a round link),
//                 drum_radius_m, drum_length_m of the joint's housing (all optional);
//                 bends_m [x, y, z, x, y, z ...] corners of the link (optional)
//   [under_test]  joint (its name); lowest, highest (motion during the test; optional, both or
//                 neither)
//   [load]        mass_kg, distance_m, q_peak; gravity_m_s2 = 9.81 (optional)
//   [surrogate]   distance_m = 0.5 (optional)
//
// Angles count as the robot's log counts them: same zero, same sign. The tested joint's axis is
// horizontal in the pose in which the others are held, and points so that a positive turn raises
// the load in front of it. [load], [surrogate] and the motion during the test are for drawings of a
// known joint; a report draws what it identified instead.

#include <cstdint>
#include <string>
#include <string_view>

#include "ingest/manifest/toml_table.h"
#include "robot/joint_under_test.h"

namespace tribolog::ingest::manifest {

inline constexpr std::uint64_t largest_robot_bytes = 1 << 20;

/// @throw InputError at file:line:column for whatever is missing, unknown, impossible or misspelt.
robot::RobotDescription read_robot(const std::string& path);

/// The same from a text. @param file its name, for messages.
robot::RobotDescription parse_robot(std::string_view text, const std::string& file);

/// The file that `description` of a [robot] table names; empty where there is no such key.
/// @throw InputError at the key if the name is empty or cannot be one of a file.
std::string read_description_name(const TomlTable& robot);

}  // namespace tribolog::ingest::manifest
