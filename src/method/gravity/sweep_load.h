#pragma once
// Internal to the sweep stage: Coulomb friction that grows with the load, as a further column of
// the regression of a sweep of varying speed.
//
// The column is sgn(q') |cos(q - q_peak)|; the angle in it comes from the fit itself. It is taken
// up only if strokes that took no part in the fit are described better with it, by more than twice
// the standard error of the gain over the strokes, and if friction grows with the load.

#include <vector>

#include "method/gravity/sweep_regression.h"

namespace tribolog {

/// @param fit of the design without the column, its columns of gravity filled.
/// @return the fit with the column, `design` extended by it; or `fit` with `design` as it was.
SweepGravityFit with_load_where_it_pays(const std::vector<const Recording*>& recordings,
                                        const SweepSamples& samples, SweepDesign& design,
                                        double middle_rad, const std::vector<std::size_t>& blocks,
                                        const SweepGravityFit& fit);

}  // namespace tribolog
