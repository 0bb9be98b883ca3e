#pragma once
// The median, which a few wild samples do not move.

#include <vector>

namespace tribolog {

/// The middle value (the upper one of two); NaN of nothing.
double median(std::vector<double> values);

/// Of the differences of neighbours: the interval of a clock. NaN of fewer than two values.
double median_interval(const std::vector<double>& rising);

}  // namespace tribolog
