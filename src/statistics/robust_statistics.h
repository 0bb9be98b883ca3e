#pragma once
// Centre, scatter and distance that a few outliers do not move.

#include <cstddef>
#include <vector>

namespace tribolog::archive {

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

}  // namespace tribolog::archive
