#pragma once
// What figures draw beside a calibration's numbers: samples and fitted curves, no result.

#include <vector>

#include "method/gravity/cog_sweep.h"
#include "method/hysteresis/hysteresis_loop.h"
#include "method/selection/friction_parameters.h"

namespace tribolog::calibration {

struct Curves {
  method::gravity::SweepCurves rough;
  method::gravity::SweepCurves precise;
  std::vector<method::hysteresis::LoopTrace> loops;  ///< One for each oscillation of the result.
  method::selection::FrictionCurve friction;         ///< Of the recommended estimator's curve.
};

}  // namespace tribolog::calibration
