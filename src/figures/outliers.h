#pragma once
// Where an axis ends, so that a few far outliers do not flatten all others.

#include <vector>

namespace tribolog::figures {

/// The distance within which most of these lie, where the few others are several times as far; 0
/// where there are no such outliers. Distances that are not finite do not count.
double reach_of_the_many(std::vector<double> distances);

}  // namespace tribolog::figures
