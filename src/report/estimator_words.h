#pragma once
// Estimators and the paper's joint in words.

#include <string>

namespace tribolog::report {

/// What the point is, in words: "z = 0 while the arm rises".
std::string point_meaning(const std::string& point);

/// Is this the paper's joint (or its reconstruction)? By the robot's name and the gear ratio.
bool is_papers_joint(const std::string& robot, double gear_ratio);

}  // namespace tribolog::report
