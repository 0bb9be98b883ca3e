#pragma once
// The regression behind the sweep stage, with its noise and its load.

#include <cstddef>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "joint/degrees.h"
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

// Internal to the sweep stage: the regression behind it.
//
//   constant speed:  T = offset(recording, direction) + G cos(q - q_peak)
//   varying speed:   T = offset + Coulomb sgn(q') + viscous q' + inertia q'' + G cos(q - q_peak)
//                        [+ load sgn(q') |cos(q - q_peak)|]
//
// A gear that yields under load turns the motor by up to `twist` further than the link: with the
// encoder at the motor q = q_link + twist cos(q_link - q_peak), and gravity
//   G cos(q_link - q_peak) = G cos(q - q_peak) + G twist / 2 sin 2(q - q_peak) + ...
// Near the peak that only shifts the peak; over a long range at constant speed the two differ.
// There the twist is always free, so that the interval of the angle includes what the gear may
// yield.
//
// An offset that drifts with time looks like a function of the angle in each direction, but with
// opposite slopes there and back: with both directions recorded it is a column of its own, -1 at
// the start of a recording and 1 at its end.

/// Columns of the regression T = X c. Those of gravity are the first.
struct SweepDesign {
  Eigen::MatrixXd x;
  Eigen::VectorXd y;
  Eigen::Index offsets{};  // first column of the offsets
  Eigen::Index offset_count{};
  Eigen::Index direction{-1};  // Coulomb column of a varying sweep
  Eigen::Index speed{-1};
  Eigen::Index acceleration{-1};
  Eigen::Index drift{-1};     // of the offset with the time, where both directions were recorded
  Eigen::Index twist{-1};     // of the gear; where the range shows it
  Eigen::Index second{-1};    // of twice the angle: cosine, and sine behind it
  Eigen::Index spring{-1};    // of the angle
  Eigen::Index by_speed{-1};  // first of those of friction's shape by speed
  Eigen::Index load{-1};      // sgn(q') |cos(q - q_peak)|, last; only where it pays
  std::vector<std::size_t> offset_of_sample;
  std::optional<double> inertia_at_joint;  // subtracted
};

/// @param gravity_columns are left free at the front: two for cosine and sine, or one for the angle
/// alone.
/// @param with_twist a column for the twist of the gear, filled by the fit.
/// @param inertia_at_joint known beforehand: torque at the motor per joint acceleration [N·m
/// s²/rad]. It is subtracted, and has no column. Only at varying speed.
SweepDesign sweep_design(const motion::Sweep& sweep, Eigen::Index gravity_columns,
                         bool with_twist = false,
                         const std::optional<double>& inertia_at_joint = {});

/// From this range on [rad] a twist of the gear can be distinguished from a shifted peak.
inline constexpr double least_range_for_twist_rad = 60 / joint::degrees_per_rad;

/// Number of half widths beyond which a torque of the angle, or an offset in addition to one, is
/// not due to chance, allowing for few blocks and several tests: 4.3 standard errors of a normal
/// variable.
inline constexpr double surely_shown = 2.2;

/// Half widths of an interval from which a term is not chance alone: one file in seven is beyond.
inline constexpr double hinted_at = 0.75;

/// From this range on [rad] terms of twice the angle can be distinguished from gravity.
inline constexpr double least_range_for_second_rad = 40 / joint::degrees_per_rad;

/// Angle of the link from the gravity peak, where the motor is at x from it [rad, joint side].
/// @param twist_rad under the full gravity torque.
double link_from_peak_rad(double x, double twist_rad);

struct SweepGravityFit {
  statistics::Estimate q_peak_rad;
  statistics::Estimate gravity_Nm;
  std::optional<statistics::Estimate> twist_rad;  ///< Where it is a column.
  /// Chi-square of "there is no gravity" with two degrees of freedom. The amplitude alone does not
  /// show it: that of noise is positive too.
  double evidence{};
  statistics::BlockRegression regression;
  /// Rows q_peak, gravity and twist: their shift by the error of each block.
  Eigen::MatrixXd block_shifts;
  double freedom{};  ///< Degrees of freedom of the shifts' scatter.
};

/// Amplitude and angle together, about the sweep's middle; fills the two columns of gravity.
/// @param blocks of each sample, for block_regression().
SweepGravityFit fit_amplitude_and_angle(const motion::Sweep& sweep, SweepDesign& design,
                                        double middle_rad, const std::vector<std::size_t>& blocks);

/// The angle alone, with known amplitude and twist: Gauss-Newton on T = offset + G cos(q_link -
/// q_peak).
/// @param start_rad the sweep's middle where that is near the peak, half a turn from it where it is
/// near the trough.
/// @param twist_rad 0 where it is not known.
SweepGravityFit fit_angle(const motion::Sweep& sweep, SweepDesign& design, double start_rad,
                          const statistics::Estimate& gravity_Nm, double twist_rad,
                          const std::vector<std::size_t>& blocks);

/// Change of the fitted coefficients by a torque `extra_Nm` (one value per sample) added to the
/// measured one.
Eigen::VectorXd effect_on_coefficients(const SweepDesign& design, const Eigen::VectorXd& extra_Nm);

/// A change of a sweep's results.
struct GravityShift {
  double q_peak_rad{};
  double gravity_Nm{};
};

/// How far a torque `extra_Nm` (one value per sample) in a sweep's log has shifted its peak angle
/// and its gravity torque.
/// @param amplitude_known the sweep's fit took the gravity torque from elsewhere.
GravityShift effect_on_gravity(const motion::Sweep& sweep, const CogSweepResult& found,
                               bool amplitude_known, const Eigen::VectorXd& extra_Nm);

}  // namespace tribolog::method::gravity
