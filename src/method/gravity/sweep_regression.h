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

/// Standard deviation of what the residual holds beyond white noise [N·m]: torque ripple, friction
/// that changes with the angle. 0 below what sampling of the two variances explains.
double torque_ripple_Nm(double residual_sd_Nm, double white_variance);

// Internal to the sweep stage: the regression behind it.
//
//   constant speed:  T = offset(recording, direction) + G cos(q - q_peak)
//   varying speed:   T = offset + Coulomb sgn(q') + viscous q' + inertia q'' + G cos(q - q_peak)
//                        [+ load sgn(q') |cos(q - q_peak)|]
//
// A gear that gives under the load turns the motor by up to `twist` further than the link: with the
// encoder at the motor q = q_link + twist cos(q_link - q_peak), and gravity
//   G cos(q_link - q_peak) = G cos(q - q_peak) + G twist / 2 sin 2(q - q_peak) + ...
// Near the peak that is a turned peak and nothing else; over a long way at constant speed the two
// differ. There the
// twist is always free, so that the interval of the angle holds what the gear may give.
//
// An offset that drifts with the time has the angle's shape in each direction, but the opposite one
// there and back: with both directions recorded it is a column of its own, -1 at the beginning of a
// recording and 1 at its end.

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
  Eigen::Index twist{-1};     // of the gear; where the range tells it
  Eigen::Index second{-1};    // of twice the angle: cosine, and sine behind it
  Eigen::Index spring{-1};    // of the angle
  Eigen::Index by_speed{-1};  // first of those of friction's shape by speed
  Eigen::Index load{-1};      // sgn(q') |cos(q - q_peak)|, last; only where it pays
  std::vector<std::size_t> offset_of_sample;
  std::optional<double> inertia_at_joint;  // taken off
};

/// @param gravity_columns are left free at the front: two for cosine and sine, or one for the angle
/// alone.
/// @param with_twist a column for the twist of the gear, filled by the fit.
/// @param inertia_at_joint known beforehand: torque at the motor by the joint's acceleration. It is
/// taken off, and has no column. Only at varying speed.
SweepDesign sweep_design(const motion::Sweep& sweep, Eigen::Index gravity_columns,
                         bool with_twist = false,
                         const std::optional<double>& inertia_at_joint = {});

/// From this range on [rad] a twisted gear is told from a turned peak.
inline constexpr double least_range_for_twist_rad = 60 / joint::degrees_per_rad;

/// Half widths from which on a torque of the angle, or an offset beside one, is none that chance
/// gives, few blocks and several questions reckoned in: 4.3 standard errors of a normal number.
inline constexpr double surely_shown = 2.2;

/// From this one on [rad] what goes with twice the angle is told from gravity.
inline constexpr double least_range_for_second_rad = 40 / joint::degrees_per_rad;

/// Of the link, less the angle of the peak: that of the motor, less the peak's, being x.
/// @param twist_rad under the whole gravity torque.
double link_from_peak_rad(double x, double twist_rad);

struct SweepGravityFit {
  statistics::Estimate q_peak_rad;
  statistics::Estimate gravity_Nm;
  std::optional<statistics::Estimate> twist_rad;  ///< Where it is a column.
  /// Chi-square of "there is no gravity" with two degrees of freedom. The amplitude alone cannot
  /// tell: noise too has a positive one.
  double evidence{};
  statistics::BlockRegression regression;
  /// Rows q_peak, gravity and twist: what the error of each block does to them.
  Eigen::MatrixXd block_shifts;
  double freedom{};  ///< Degrees of freedom of their scatter.
};

/// Amplitude and angle together, about the sweep's middle; fills the two columns of gravity.
/// @param blocks of each sample, for block_regression().
SweepGravityFit fit_amplitude_and_angle(const motion::Sweep& sweep, SweepDesign& design,
                                        double middle_rad, const std::vector<std::size_t>& blocks);

/// The angle alone, amplitude and twist being known: Gauss-Newton on T = offset + G cos(q_link -
/// q_peak).
/// @param twist_rad 0 where it is not known.
SweepGravityFit fit_angle(const motion::Sweep& sweep, SweepDesign& design, double middle_rad,
                          const statistics::Estimate& gravity_Nm, double twist_rad,
                          const std::vector<std::size_t>& blocks);

/// What a torque `extra_Nm` (one value per sample) laid on the measured one does to the fitted
/// coefficients.
Eigen::VectorXd effect_on_coefficients(const SweepDesign& design, const Eigen::VectorXd& extra_Nm);

/// A change of what a sweep gave.
struct GravityShift {
  double q_peak_rad{};
  double gravity_Nm{};
};

/// What a torque `extra_Nm` (one value per sample) in a sweep's log has done to its angle of the
/// peak and its gravity torque.
/// @param amplitude_known the sweep's fit took the gravity torque from elsewhere.
GravityShift effect_on_gravity(const motion::Sweep& sweep, const CogSweepResult& found,
                               bool amplitude_known, const Eigen::VectorXd& extra_Nm);

// Internal to the sweep stage: torque of the angle that is no gravity.
//
// Its columns are cos 2y and sin 2y, y from the sweep's middle, in place of the twist's; or y
// alone, of a spring, where a twist would be negative (no gear gives against its load) and the data
// do not ask for the other two. At varying speed a spring looks like inertia and takes no part.

/// @param fit of the design without them, its columns of gravity filled.
/// @return the fit with them, `design` with them in place; or `fit` with `design` as it was, where
/// they do not show, or move neither angle nor amplitude by what matters.
/// @param left_Nm receives the amplitude of one that is too large to be taken for one: then
/// something else is wrong, and the fit stays as it was.
SweepGravityFit with_torque_of_angle_where_it_shows(const motion::Sweep& sweep, SweepDesign& design,
                                                    double middle_rad, double range_rad,
                                                    const std::vector<std::size_t>& blocks,
                                                    const SweepGravityFit& fit, double& left_Nm);

/// The design with further columns of the angle, in place of the twist's.
SweepDesign design_of_angle(const motion::Sweep& sweep, double middle_rad, bool second, bool spring,
                            const std::optional<double>& inertia_at_joint = {});

/// What was found with such columns; absent without them.
std::optional<TorqueOfAngle> torque_of_angle(const motion::Sweep& sweep, const SweepDesign& design,
                                             double middle_rad, const SweepGravityFit& fit);

// Internal to the sweep stage: friction that is no straight line of the speed.
//
// A sweep of varying speed passes through the Stribeck dip at angles of its own, and a straight
// line leaves there what a torque of the angle, or a twist of the gear, can be mistaken for. Taken
// up are columns sgn(q') max(0, |q'| - v_k), v_k at quantiles of the speed: a line with kinks. They
// are laid across those of Coulomb torque and viscous friction, which keep their meaning.

/// @param fit of the design without the columns, its columns of gravity filled.
/// @return the fit with the columns, `design` with them in place, where held-out strokes are
/// described better with them; or `fit` with `design` as it was.
SweepGravityFit with_kinks_where_they_pay(const motion::Sweep& sweep, SweepDesign& design,
                                          double middle_rad, const std::vector<std::size_t>& blocks,
                                          const SweepGravityFit& fit);

// Internal to the sweep stage: Coulomb friction that grows with the load, as a further column of
// the regression of a sweep of varying speed.
//
// The column is sgn(q') |cos(q - q_peak)|; the angle in it comes from the fit itself. It is taken
// up only if strokes that took no part in the fit are described better with it, by more than twice
// the standard error of the gain over the strokes, and if friction grows with the load.

/// @param fit of the design without the column, its columns of gravity filled.
/// @return the fit with the column, `design` extended by it; or `fit` with `design` as it was.
SweepGravityFit with_load_where_it_pays(const motion::Sweep& sweep, SweepDesign& design,
                                        double middle_rad, const std::vector<std::size_t>& blocks,
                                        const SweepGravityFit& fit);

}  // namespace tribolog::method::gravity
