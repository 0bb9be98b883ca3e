#pragma once
// Points, angles and sentences that the drawings share.

#include <cstddef>
#include <initializer_list>
#include <string>

#include <Eigen/Core>

#include "render/figure/scene.h"
#include "robot/joint_under_test.h"

namespace tribolog::paper::scenes {

inline render::figure::Point3 point(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

/// "−22.23°", to so many places.
std::string degrees_text(double rad, int places);
/// Places with which the ends of a range are told apart.
int places_for(const robot::AngleRange& range);
/// "400 mm"
std::string millimetres_text(double metres);
/// "79.17 kg"
std::string kilogram_text(double kg);
/// A text from a file as one in a picture: without the braces of markup and without control
/// characters, cut to so many bytes.
std::string drawn_text(const std::string& text, std::size_t limit);
/// The name of a joint as an index: up to three letters or digits as they are, "3" or "J3"; others
/// in brackets.
std::string index_text(const std::string& joint_name);
/// "Dimensions are approximate." or nothing.
std::string dimensions_note(const robot::RobotDescription& robot);
/// One after the other; those that say nothing are left out.
std::string sentences(std::initializer_list<std::string> all);

}  // namespace tribolog::paper::scenes
