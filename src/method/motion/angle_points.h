#pragma once
// Where a recorded angle is known, and how well.
//
// An angle in steps, slowly passed, is best known where it steps: between two samples there it is
// on the edge between two steps, to within its way from one sample to the next. The samples on a
// step tell no more than that the angle is within it; they count where the angle turns round or
// the recording begins or ends, and no edge tells more.

#include <vector>

#include "statistics/smoothing_spline.h"

namespace tribolog {

/// @param step_rad of the angle; 0: continuous, and all samples count alike.
CurvePoints angle_points(const std::vector<double>& t_s, const std::vector<double>& q_rad,
                         double step_rad);

}  // namespace tribolog
