#pragma once
// Medians and quantiles, which a few wild samples do not move.

#include <cstddef>
#include <vector>

#include "statistics/estimate.h"

namespace tribolog::statistics {

/// The middle value (the upper one of two); NaN of nothing.
double median(std::vector<double> values);

/// Of the differences of neighbours: the interval of a clock. NaN of fewer than two values.
double median_interval(const std::vector<double>& rising);

// The ends of a 95 % interval from resampled values.

/// 2.5 % and 97.5 % quantiles about an estimate, which stays inside. Values that are not finite do
/// not count; where they are more than one in twenty the interval is not finite either.
Estimate percentile_interval(double estimate, std::vector<double> values);

/// The same for a root mean square. Noise can only enlarge one, in the data as in each resample:
/// what it adds to the mean of squares is taken off twice, and the lower end may be zero.
Estimate root_mean_square_interval(double estimate, std::vector<double> values);

// Centre, scatter and distance that a few outliers do not move.

/// @throw std::logic_error without values.
double median_of(std::vector<double> values);

/// Qn of Rousseeuw and Croux (1993): an order statistic of the differences of all pairs, which
/// estimates the standard deviation of normal values with 82 % of its efficiency, and stands half
/// of them being outliers. Of more than 400 values, 400 in even steps of their order are taken.
/// @throw std::logic_error with less than two values.
double pairwise_scatter(std::vector<double> values);

/// Degrees of freedom of pairwise_scatter() of so many independent values.
double scatter_freedom(std::size_t values);

/// The deviate beyond which, on either side, one normal value lies with this probability
/// (between 0 and 1, both excluded).
double deviate_of(double probability);

}  // namespace tribolog::statistics
