#pragma once
// Medians and quantiles, which a few outliers do not move.

#include <cstddef>
#include <vector>

#include "statistics/estimate.h"

namespace tribolog::statistics {

/// The middle value (of an even number, the upper of the two); NaN without values.
double median(std::vector<double> values);

/// The value below which this share of them lies (0 to 1; between two, the lower one); NaN without
/// values.
double value_at_share(std::vector<double> values, double share);

/// The largest less the smallest value, a two-hundredth of the values left out at either end: a
/// start's jump and outliers do not set the scale of a signal. NaN without values.
double range_without_ends(std::vector<double> values);

/// Median difference of neighbours: the interval of a clock. NaN with fewer than two values.
double median_interval(const std::vector<double>& rising);

/// Mean interval of an even clock some of whose stamps may be missing, or rounded (2 ms and 3 ms in
/// turn for 2.5 ms). NaN with fewer than two values.
double even_interval(const std::vector<double>& rising);

// Robust centre, scatter and distance.

/// @throw std::logic_error without values.
double median_of(std::vector<double> values);

/// Qn of Rousseeuw and Croux (1993): an order statistic of the differences of all pairs, which
/// estimates the standard deviation of normal values with an efficiency of 82 % and a breakdown
/// point of 50 %. Of more than 400 values, 400 evenly spaced order statistics are taken.
/// @throw std::logic_error with fewer than two values.
double pairwise_scatter(std::vector<double> values);

/// Degrees of freedom of pairwise_scatter() of so many independent values.
double scatter_freedom(std::size_t values);

/// The deviate beyond which, on either side, a standard normal value lies with this two-sided
/// probability (between 0 and 1, both excluded).
double deviate_of(double probability);

}  // namespace tribolog::statistics
