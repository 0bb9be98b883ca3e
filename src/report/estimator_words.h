#pragma once
// Estimators in words.

#include <string>

namespace tribolog::report {

/// What the point is, in words: "z = 0 while the arm rises".
std::string point_meaning(const std::string& point);

}  // namespace tribolog::report
