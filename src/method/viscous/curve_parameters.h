#pragma once
// The parameters of a fitted curve model in SI, with intervals.
//
// Interval: covariance of the linearised model over blocks, one block for each speed, times
// Student's t; carried to each parameter by its derivatives. Parameters that are positive by nature
// (a Stribeck speed, a power) get the interval of their logarithm.

#include <vector>

#include "method/viscous/curve_fit.h"
#include "statistics/estimate.h"

namespace tribolog::method::viscous {

struct CurveParameter;

/// @param samples those that were fitted.
std::vector<CurveParameter> curve_parameters(const CurveFit& fit,
                                             const std::vector<CurveSample>& samples);

}  // namespace tribolog::method::viscous
