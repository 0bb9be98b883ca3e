#pragma once
// Numbers in documents.

#include <string>

namespace tribolog::render {

/// With up to `digits` digits behind the point (0 to 6) and no more than it takes: "12.5", "-0.07",
/// "3". The same in every locale. Not finite: "0".
std::string short_number(double value, int digits = 2);

}  // namespace tribolog::render
