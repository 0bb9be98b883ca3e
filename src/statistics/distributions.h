#pragma once
// Student's t: the factor of a 95 % interval, and the normal number of the same rank. Chances of an
// F ratio.

namespace tribolog::statistics {

/// The 97.5 % quantile of the normal distribution: that of Student's t without end.
inline constexpr double normal_975 = 1.959963984540054;

/// The 97.5 % quantile for this many degrees of freedom (>= 1, need not be whole; may be infinite).
/// With less than one degree of freedom nothing can be said: infinity.
double student_t_975(double degrees_of_freedom);

/// Chance of a ratio of variances as large as `f` or larger where both are of the same noise.
/// @param above, below degrees of freedom, > 0. @return 1 for a ratio that is no number.
double f_upper_tail(double f, double above, double below);

// A Student-t number as the normal one of the same rank.

/// The normal quantile at the t distribution's probability of `t`; the same in both tails.
/// @param freedom > 0, need not be whole.
double normal_score(double t, double freedom);

}  // namespace tribolog::statistics
