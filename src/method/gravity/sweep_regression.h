#pragma once
// Internal to the sweep stage: the regression behind it.
//
//   constant speed:  T = offset(recording, direction) + G cos(q - q_peak)
//   varying speed:   T = offset + Coulomb sgn(q') + viscous q' + inertia q'' + G cos(q - q_peak)
//
// An offset that drifts with time looks like a function of the angle in each direction, but with
// opposite slopes there and back: with both directions recorded it is a column of its own, -1 at
// the start of a recording and 1 at its end.

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "method/gravity/cog_sweep.h"
#include "method/motion/sweep_samples.h"
#include "statistics/block_regression.h"
#include "statistics/estimate.h"

namespace tribolog::method::gravity {

/// Variance of the white noise of the torque [N²·m²] from third differences of neighbouring
/// samples, in which everything slower than a few samples drops out. 0 without neighbours.
double white_torque_variance(const motion::Sweep& sweep);

/// Standard deviation of the residual beyond white noise [N·m]: torque ripple, friction that varies
/// with the angle. 0 where sampling of the two variances explains the difference.
double torque_ripple_Nm(double residual_sd_Nm, double white_variance);

/// Columns of the regression T = X c. Those of gravity are the first.
struct SweepDesign {
  Eigen::MatrixXd x;
  Eigen::VectorXd y;
  Eigen::Index offsets{};  // first column of the offsets
  Eigen::Index offset_count{};
  Eigen::Index direction{-1};  // Coulomb column of a varying sweep
  Eigen::Index speed{-1};
  Eigen::Index acceleration{-1};
  std::vector<std::size_t> offset_of_sample;
};

/// @param gravity_columns are left free at the front: two for cosine and sine, or one for the angle
/// alone.
SweepDesign sweep_design(const motion::Sweep& sweep, Eigen::Index gravity_columns);

struct SweepGravityFit {
  statistics::Estimate q_peak_rad;
  statistics::Estimate gravity_Nm;
  /// Chi-square of "there is no gravity" with two degrees of freedom. The amplitude alone does not
  /// show it: that of noise is positive too.
  double evidence{};
  statistics::BlockRegression regression;
};

/// Amplitude and angle together, about the sweep's middle; fills the two columns of gravity.
/// @param blocks of each sample, for block_regression().
SweepGravityFit fit_amplitude_and_angle(const motion::Sweep& sweep, SweepDesign& design,
                                        double middle_rad, const std::vector<std::size_t>& blocks);

/// The angle alone, with a known amplitude: Gauss-Newton on T = offset + G cos(q - q_peak).
/// @param start_rad the sweep's middle where that is near the peak, half a turn from it where it is
/// near the trough.
SweepGravityFit fit_angle(const motion::Sweep& sweep, SweepDesign& design, double start_rad,
                          double gravity_Nm, const std::vector<std::size_t>& blocks);

/// The residuals of a fit less what joints have beside gravity and a line of friction: torque that
/// changes smoothly over the range of angles, by fewer than three periods, and friction that grows
/// with the load and bends over the speed. Ripple and vibration are sought in what is left.
/// @param result whose range is known. @param q_peak_rad of the fit.
Eigen::VectorXd rough_residuals(const motion::Sweep& sweep, const Eigen::VectorXd& residuals,
                                const CogSweepResult& result, double q_peak_rad);

}  // namespace tribolog::method::gravity
