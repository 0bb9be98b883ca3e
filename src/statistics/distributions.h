#pragma once
// Student's t: the factor of a 95 % interval, and the normal number of the same rank.

namespace tribolog::statistics {

/// The 97.5 % quantile of the normal distribution: that of Student's t without end.
inline constexpr double normal_975 = 1.959963984540054;

/// The 97.5 % quantile for this many degrees of freedom (>= 1, need not be whole; may be infinite).
/// With less than one degree of freedom nothing can be said: infinity.
double student_t_975(double degrees_of_freedom);

// A Student-t number as the normal one of the same rank.

/// The normal quantile at the t distribution's probability of `t`; the same in both tails.
/// @param freedom > 0, need not be whole.
double normal_score(double t, double freedom);

}  // namespace tribolog::statistics
