#pragma once
// The parameters of a fitted curve model in SI, with intervals.
//
// Interval: standard error from the block covariance of the linearised model, one block for each
// speed, times Student's t; propagated to each parameter by its derivatives. Parameters that are
// positive by nature (a Stribeck speed, a power) get the interval of their logarithm.

#include <vector>

#include "method/viscous/curve_fit.h"
#include "statistics/estimate.h"

namespace tribolog::method::viscous {

struct CurveParameter;

/// @param samples those that were fitted.
std::vector<CurveParameter> curve_parameters(const CurveFit& fit,
                                             const std::vector<CurveSample>& samples);

}  // namespace tribolog::method::viscous
