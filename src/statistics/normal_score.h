#pragma once
// A Student-t number as the normal one of the same rank.

namespace tribolog::history {

/// The normal quantile at the t distribution's probability of `t`; the same in both tails.
/// @param freedom > 0, need not be whole.
double normal_score(double t, double freedom);

}  // namespace tribolog::history
