#pragma once
// What makes a logged speed wrong by a factor.

#include <string>

namespace tribolog {

/// The usual causes of a factor logged / true, in words; "no usual cause has this factor" where
/// none fits. Several that fit are all named.
/// @param half_width of the factor, 95 %.
std::string likely_cause_of_scale(double factor, double half_width, double gear_ratio);

}  // namespace tribolog
