#pragma once
// Points, angles and sentences that the drawings share.

#include <string>

#include <Eigen/Core>

#include "robot/robot_description.h"

#include "render/scene.h"

namespace tribolog::scenes {

inline render::Point3 point(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

/// "−22.23°", to so many places.
std::string degrees_text(double rad, int places);
/// "400 mm"
std::string millimetres_text(double metres);
/// "79.17 kg"
std::string kilogram_text(double kg);
/// A digit as it is; a longer name in brackets, so that it can follow a letter as an index.
std::string index_text(const std::string& joint_name);
/// " Dimensions are approximate." or nothing.
std::string dimensions_note(const RobotDescription& robot);

}  // namespace tribolog::scenes
