#pragma once
// The name of a reading as a figure prints it.

#include <string>

namespace tribolog::wording {

/// The reading's words with the subscript marked up: "break-away torque T_{s}".
std::string reading_label(const std::string& reading);

}  // namespace tribolog::wording
