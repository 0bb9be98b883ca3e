#include "statistics/distributions.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <boost/math/distributions/fisher_f.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>

namespace tribolog::statistics {

double student_t_975(double degrees_of_freedom) {
  namespace math = boost::math;
  if (!(degrees_of_freedom >= 1)) return std::numeric_limits<double>::infinity();
  // Without promotion to long double: the same digits on every machine.
  using InDouble = math::policies::policy<math::policies::promote_double<false>>;
  return math::quantile(math::students_t_distribution<double, InDouble>(degrees_of_freedom), 0.975);
}

double student_t_probability(double t, int even_freedom) {
  const double cos2 = even_freedom / (even_freedom + t * t);
  double term = 1;
  double sum = 1;
  for (int k = 1; k < even_freedom / 2; ++k) {
    term *= cos2 * (2 * k - 1) / (2 * k);
    sum += term;
  }
  return 0.5 + 0.5 * t / std::sqrt(even_freedom + t * t) * sum;
}

double log_normal_probability(double x) {
  constexpr double far = -30;  // the probability's asymptote is exact to a thousandth
  if (x < far) return -0.5 * x * x - std::log(-x * std::sqrt(2 * std::numbers::pi));
  return std::log(0.5 * std::erfc(-x / std::numbers::sqrt2));
}

double f_upper_tail(double f, double above, double below) {
  namespace math = boost::math;
  if (std::isnan(f)) return 1;
  if (std::isinf(f)) return 0;
  return math::cdf(math::complement(math::fisher_f(above, below), std::max(0.0, f)));
}

double normal_score(double t, double freedom) {
  namespace math = boost::math;
  if (!std::isfinite(t)) return std::isnan(t) ? 0 : std::copysign(37.0, t);
  const double tail = math::cdf(math::students_t(freedom), -std::abs(t));
  const double smallest = std::numeric_limits<double>::min();
  return std::copysign(-math::quantile(math::normal(), std::clamp(tail, smallest, 0.5)), t);
}

}  // namespace tribolog::statistics
