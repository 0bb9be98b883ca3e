#pragma once
// The ends of a 95 % interval from resampled values.

#include <vector>

#include "statistics/estimate.h"

namespace tribolog::bootstrap {

/// 2.5 % and 97.5 % quantiles about an estimate, which stays inside. Values that are not finite do
/// not count; where they are more than one in twenty the interval is not finite either.
Estimate percentile_interval(double estimate, std::vector<double> values);

/// The same for a root mean square. Noise can only enlarge one, in the data as in each resample:
/// what it adds to the mean of squares is taken off twice, and the lower end may be zero.
Estimate root_mean_square_interval(double estimate, std::vector<double> values);

}  // namespace tribolog::bootstrap
