#pragma once
// How much later a loop's torque was logged than its angle.
//
// A lag looks like bristle damping that is smaller by stiffness times lag. One that sweeps and runs
// show beyond doubt is taken off the loops' torque; what is left of it unknown goes into the
// intervals (lugre_fit.h). Nobody knows whether it was a delay's or a first-order filter's, which
// also rounds the torque where it bends.

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "joint/recording.h"
#include "statistics/estimate.h"

namespace tribolog::method::hysteresis {

struct LoopTiming {
  double lag_s{};         ///< Taken off; 0: none is beyond doubt. > 0: the torque is late.
  double half_width_s{};  ///< 95 %; 0: known to be zero.
};

/// @param lag_s absent: it is stated that there is none, or nothing shows it.
LoopTiming timing_of_loops(const std::optional<statistics::Estimate>& lag_s);

/// The recording with its torque advanced by the lag, aligned with the angle that it belongs to.
/// Samples at the ends, whose torque was not recorded, are left out.
joint::Recording aligned(const joint::Recording& recording, double lag_s);

/// A torque along straight lines between its samples, behind a first-order filter whose lag is
/// taken off again: int_0^inf exp(-s / tau) / tau f(t + tau - s) ds.
/// @param t_s ascending, one for each sample. @param tau_s time constant, > 0.
Eigen::VectorXd rounded_by_filter(const std::vector<double>& t_s, const Eigen::VectorXd& torque_Nm,
                                  double tau_s);

}  // namespace tribolog::method::hysteresis
