#pragma once
// Student's t: the factor of a 95 % interval, and the normal deviate of equal probability. Tail
// probability of an F ratio.

namespace tribolog::statistics {

/// The 97.5 % quantile of the normal distribution: the limit of Student's t for infinite degrees of
/// freedom.
inline constexpr double normal_975 = 1.959963984540054;

/// The 97.5 % quantile for this many degrees of freedom (need not be whole; may be infinite). Below
/// one degree of freedom nothing can be said: infinity.
double student_t_975(double degrees_of_freedom);

/// Probability below `t` in Student's distribution, a finite sum for an even number of degrees of
/// freedom (Abramowitz and Stegun, 26.7.4): for use in loops.
double student_t_probability(double t, int even_freedom);

/// log of the probability below `x` in the normal distribution, in its far tail too.
double log_normal_probability(double x);

/// Probability of a variance ratio of `f` or more where both variances are of the same noise.
/// @param above, below degrees of freedom of numerator and denominator, > 0. @return 1 if `f` is
/// NaN.
double f_upper_tail(double f, double above, double below);

// A Student-t value as the normal one of equal probability.

/// The normal quantile at the cumulative probability of `t` in Student's distribution; odd in `t`.
/// 0 if `t` is NaN.
/// @param freedom > 0, need not be whole.
double normal_score(double t, double freedom);

}  // namespace tribolog::statistics
