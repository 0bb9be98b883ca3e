#pragma once
// Words about a joint whose torque constant is not known: its torques are numbers of amperes.

#include <string>

namespace tribolog::wording {

/// Units of torques as those of currents: "N·m" is "A", "kN·m·s/rad" is "kA·s/rad", "kg·m²" is
/// "A·s²/rad".
std::string in_amperes(std::string text);

/// The same of a page, but for its scripts, whose data are as they are in files.
std::string page_in_amperes(const std::string& html);

}  // namespace tribolog::wording
