#pragma once
// A dataset from disk: the manifest and every log it names.

#include <string>
#include <vector>

#include "joint/dataset.h"

namespace tribolog::ingest::dataset {

/// Reads a manifest (manifest_file.h says what it holds), its logs (csv_reader.h says which) and
/// the robot's description where one is named (robot_file.h). Paths in it are relative to the
/// manifest. The recordings are in SI: angle and speed at the joint, torque and bristle deflection
/// at the motor. A description of another joint, or whose range of motion the logs leave, gives a
/// note.
/// @param joint by name, of a whole robot's manifest (robot_joints.h); empty: of a single joint's.
/// @throw InputError for a manifest, description or log that cannot be used, at file:line:column.
joint::Dataset read_dataset(const std::string& manifest_path, const std::string& joint = {});

/// The joints of a robot's manifest, in their order; none: it is a single joint's.
/// @throw InputError as read_dataset().
std::vector<std::string> joints_of_robot(const std::string& manifest_path);

}  // namespace tribolog::ingest::dataset
