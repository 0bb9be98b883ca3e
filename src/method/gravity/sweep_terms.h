#pragma once
// Internal to the sweep stage: further terms of a sweep's torque, each taken where the data ask for
// it.

#include <cstddef>
#include <optional>
#include <vector>

#include "method/gravity/cog_sweep.h"
#include "method/gravity/sweep_regression.h"
#include "method/motion/sweep_samples.h"

namespace tribolog::method::gravity {

// Torque of the angle that is not gravity.
//
// Its columns are cos 2y and sin 2y, y from the sweep's middle, in place of the twist's; or y
// alone, of a spring, where a twist would be negative (no gear yields against its load) and the
// data do not require the other two. At varying speed a spring looks like inertia and is not tried.

/// @param fit of the design without them, its columns of gravity filled.
/// @return the fit with them, and `design` extended by them; or `fit`, and `design` unchanged,
/// where they are not significant or move neither angle nor amplitude appreciably.
/// @param left_Nm receives the amplitude of a torque of the angle that is implausibly large: then
/// something else is wrong, and the fit stays as it was.
/// @param rivals receives fits that describe the data as well, or that the data hint at without
/// showing them: the intervals have to hold what these give.
SweepGravityFit with_torque_of_angle_where_it_shows(const motion::Sweep& sweep, SweepDesign& design,
                                                    double middle_rad, double range_rad,
                                                    const std::vector<std::size_t>& blocks,
                                                    const SweepGravityFit& fit, double& left_Nm,
                                                    std::vector<SweepGravityFit>& rivals);

/// The design with further columns of the angle, in place of the twist's.
SweepDesign design_of_angle(const motion::Sweep& sweep, double middle_rad, bool second, bool spring,
                            const std::optional<double>& inertia_at_joint = {});

/// What was found with such columns; absent if the design has none.
std::optional<TorqueOfAngle> torque_of_angle(const motion::Sweep& sweep, const SweepDesign& design,
                                             double middle_rad, const SweepGravityFit& fit);

// Friction that is not linear in speed.
//
// A sweep of varying speed passes through the Stribeck dip at particular angles, and a straight
// line leaves residuals there that can be mistaken for a torque of the angle or a twist of the
// gear. The columns added are sgn(q') max(0, |q'| - v_k), v_k at quantiles of the speed: a line
// with kinks. They are made orthogonal to those of Coulomb torque and viscous friction, which keep
// their meaning.

/// @param fit of the design without the columns, its columns of gravity filled.
/// @return the fit with the columns, and `design` extended by them, where they describe held-out
/// strokes better; or `fit`, and `design` unchanged.
SweepGravityFit with_kinks_where_they_pay(const motion::Sweep& sweep, SweepDesign& design,
                                          double middle_rad, const std::vector<std::size_t>& blocks,
                                          const SweepGravityFit& fit);

// Coulomb friction that grows with the load, as a further column of
// the regression of a sweep of varying speed.
//
// The column is sgn(q') |cos(q - q_peak)|; the angle in it comes from the fit itself. It is added
// only if it describes held-out strokes better, by more than twice the standard error of the gain
// over the strokes, and if friction grows with the load.

/// @param fit of the design without the column, its columns of gravity filled.
/// @return the fit with the column, and `design` extended by it; or `fit`, and `design` unchanged.
SweepGravityFit with_load_where_it_pays(const motion::Sweep& sweep, SweepDesign& design,
                                        double middle_rad, const std::vector<std::size_t>& blocks,
                                        const SweepGravityFit& fit);

}  // namespace tribolog::method::gravity
