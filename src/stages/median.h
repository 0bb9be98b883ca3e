#pragma once
// The median, which a few wild samples do not move.

#include <vector>

namespace tribolog {

/// The middle value (the upper one of two); NaN of nothing.
double median(std::vector<double> values);

}  // namespace tribolog
