#pragma once
// What makes a logged signal wrong by a factor.

#include <string>

#include "joint/drive.h"

namespace tribolog {

/// The usual causes of a factor logged / true of a speed, in words; "no usual cause has this
/// factor" where none fits. Several that fit are all named.
/// @param half_width of the factor, 95 %.
std::string likely_cause_of_scale(double factor, double half_width, double gear_ratio);

/// The same of a torque, found / true: unit, side of the gear, torque constant. What is true is
/// known to some per cent only.
std::string likely_cause_of_torque_scale(double factor, double half_width, const Drive& drive);

}  // namespace tribolog
