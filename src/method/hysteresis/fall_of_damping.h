#pragma once
// Bristle damping that falls with speed, s1 exp(-(w/wd)^2), beside LuGre's constant one: a bristle
// whose damping stays returns more than it has stored (H. Olsson et al., European Journal of
// Control 4 (1998) 176-195, on passivity), and a loop fit with a constant s1 puts the rest into
// stiffness, inertia and viscous friction.
//
// Tried to first order: one step of the least squares with one more column says whether the
// residuals hold such a term, and by how much the parameters would be others with it. Inertia would
// take its place; where starts and stops show the inertia, it is held at that.

#include <optional>

#include "method/hysteresis/lugre_ladder.h"
#include "method/hysteresis/lugre_problem.h"
#include "statistics/estimate.h"

namespace tribolog::method::hysteresis {

struct FallOfDamping {
  double half_at_rad_s{};    ///< Motor speed at which the damping has fallen to a half.
  double stiffness_share{};  ///< By how much the stiffness would be larger, as a share.
};

/// Present only where the residuals show it beyond doubt: a coefficient of at least two half widths
/// of its 95 % interval, an effect that counts, and a damping that falls.
/// @param contact_Nm of the problem's rows, taken off as another contact's: it stays in here.
/// @param inertia_kgm2 as starts and stops show it, motor side.
std::optional<FallOfDamping> fall_of_damping(
    const LuGreClimb& climb, const LuGreProblem& problem, const Eigen::VectorXd& contact_Nm,
    const std::optional<statistics::Estimate>& inertia_kgm2);

}  // namespace tribolog::method::hysteresis
