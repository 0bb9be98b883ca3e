#pragma once
// Internal to the gravity stage: what widens the intervals of a sweep's angle and amplitude beyond
// its residuals.

#include <cstddef>
#include <optional>
#include <vector>

#include "base/statement.h"
#include "method/gravity/cog_sweep.h"
#include "method/gravity/ripple_spectrum.h"
#include "method/gravity/sweep_regression.h"
#include "method/motion/sweep_samples.h"
#include "statistics/estimate.h"

namespace tribolog::method::gravity {

/// By a half width that is independent of its own.
statistics::Estimate widened(const statistics::Estimate& e, double by, Code why);

/// A torque of twice the angle in place of an offset.
struct InPlaceOfOffset {
  double amplitude_Nm{};
  double on_gravity_Nm{};  ///< What it adds to the gravity of a fit that takes it for the offset.
};

/// Whether the offset found may equally be a torque of the angle that is not found: with a term of
/// twice the angle in the fit it may vanish. Over less than half a turn the two look alike, and
/// shift gravity in opposite senses.
std::optional<InPlaceOfOffset> torque_in_place_of_offset(const motion::Sweep& sweep,
                                                         const SweepDesign& design, double middle,
                                                         const SweepGravityFit& fit,
                                                         const std::vector<std::size_t>& blocks,
                                                         const CogSweepResult& out);

/// The largest spring that a fit with one in place of the gear's twist does not exclude: its
/// estimate and half width. Not part of any interval; no sweep over part of a turn shows a small
/// one. @param out with the range, and what was found.
std::optional<UnseenSpring> unseen_spring(const motion::Sweep& sweep, const SweepDesign& design,
                                          double middle, const SweepGravityFit& fit,
                                          const std::vector<std::size_t>& blocks,
                                          const CogSweepResult& out);

/// Ripple of few periods a motor turn looks like gravity, or like a twist of the gear, where the
/// motor makes less than a few turns: widens angle and amplitude by the effect of ripple as large
/// as that seen, of any such period and at any phase. @param times factor on that size.
void widen_by_slow_ripple(const motion::Sweep& sweep, const SweepDesign& design, double gear_ratio,
                          double middle, const CogSweepResult& out, double times,
                          SweepGravityFit& fit);

/// Coarse steps of the torque bias amplitude and angle as much as rounding the fitted curve does;
/// noise of half a step or more averages that out (Widrow: by exp(-2 pi^2 (sd/step)^2)).
void widen_by_torque_step(const motion::Sweep& sweep, const SweepDesign& design, double middle,
                          SweepGravityFit& fit);

/// Widens the intervals to hold what fits give that the data do not exclude.
void hold_rivals(const std::vector<SweepGravityFit>& rivals, SweepGravityFit& fit);

/// How far the error of an inertia that was subtracted moves angle and amplitude.
void widen_by_inertia(const motion::Sweep& sweep, const SweepDesign& design, double half_width,
                      double middle, SweepGravityFit& fit);

/// How far the error of a twist taken from another sweep moves the angle.
void widen_by_twist(const motion::Sweep& sweep, const SweepDesign& design,
                    const statistics::Estimate& twist_rad, CogSweepResult& out, SweepBlocks& kept);

/// How far the ripple of another sweep moves the angle, each line at any phase.
void widen_by_ripple(const motion::Sweep& sweep, const SweepDesign& design, double gear_ratio,
                     const Ripple& ripple, CogSweepResult& out, SweepBlocks& kept);

}  // namespace tribolog::method::gravity
