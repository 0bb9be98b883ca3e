#pragma once
// Student's t: the factor of a two-sided 95 % interval.

namespace tribolog {

/// The 97.5 % quantile of the normal distribution: that of Student's t without end.
inline constexpr double normal_975 = 1.959963984540054;

/// The 97.5 % quantile for this many degrees of freedom (>= 1, need not be whole; may be infinite).
/// With less than one degree of freedom nothing can be said: infinity.
double student_t_975(double degrees_of_freedom);

}  // namespace tribolog
