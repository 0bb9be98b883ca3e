#pragma once
// What every export says about itself, in the comments of its format.

#include <string>
#include <vector>

#include "export/calibration/archived_joint.h"

namespace tribolog::archive {

/// Robot, joint, date and id, what it was made with, gear ratio and the conversions between the
/// sides. No line holds a line break or a character that hides; else names stand as they are, and
/// each format still has to take care of what ends its comments.
std::vector<std::string> comment_lines(const ArchivedJoint& joint);

/// One line with an estimate: "Coulomb torque at the joint: 44.96 N·m (95 %: 41.85 to 48.22),
/// usable; archived × n".
std::string estimate_line(const Quantity& quantity, double gear_ratio, Side side);

/// Text on one line, in which nothing hides.
std::string one_line(const std::string& text);

}  // namespace tribolog::archive
