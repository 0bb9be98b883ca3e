#pragma once
// The manifest of a whole robot: what its joints share stands once, and each joint in [[joints]].
//
//   schema = "tribolog-dataset-1"
//   [robot]        as for one joint; so are all tables that the joints share
//   [columns]      time = {name = "t", unit = "s"}
//   [effort]       kind = "motor_current", side = "motor"
//   [[joints]]     name, gear_ratio, gravity (optional): what stands in [joint] for one joint
//   [joints.effort]  torque_constant_Nm_A = 0.2
//   [joints.columns] angle, effort ...
//   [[joints.recording]] role, file, from_s, to_s ...
//
// A joint's tables have the keys that a dataset's have. Each adds its keys to the shared table of
// the same name, and wins where both have one; recordings, limits and known loads are added to the
// shared ones.

#include <string>
#include <vector>

#include "ingest/manifest/toml_document.h"
#include "joint/other_joints.h"

namespace tribolog::ingest::manifest {

/// In their order; empty: the manifest of a single joint.
/// @param file its name, for messages.
/// @throw InputError: a joint without a name, two of one name, a [joint] beside them.
std::vector<std::string> joint_names(const TomlNode& manifest, const std::string& file);

/// The manifest as that of this joint alone; places in the file stay those of the robot's.
/// @param name one of joint_names().
TomlNode manifest_of_joint(TomlNode manifest, const std::string& name);

/// The joint's part of a robot's document, or the whole of a single joint's.
/// @param joint empty: it is a single joint's. @param file its name, for messages.
/// @throw InputError as joint_names(): the robot has no joint of that name, or there is no name
///        where one is needed.
TomlNode document_of_joint(TomlNode document, const std::string& file, const std::string& joint);

/// The robot's joints but the one named, in their order, with the columns that have their angles.
/// Left out is a joint whose column cannot be told from its tables, for its own reader to refuse,
/// and one whose column is the named joint's own, as where each has a log of its own.
/// @param manifest of the robot. @param file its name.
std::vector<joint::OtherJoint> other_joints_of(const TomlNode& manifest, const std::string& file,
                                               const std::string& name);

}  // namespace tribolog::ingest::manifest
