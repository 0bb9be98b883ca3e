#include "statistics/normal_score.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>

namespace tribolog::history {

double normal_score(double t, double freedom) {
  namespace math = boost::math;
  if (!std::isfinite(t)) return std::isnan(t) ? 0 : std::copysign(37.0, t);
  const double tail = math::cdf(math::students_t(freedom), -std::abs(t));
  const double smallest = std::numeric_limits<double>::min();
  return std::copysign(-math::quantile(math::normal(), std::clamp(tail, smallest, 0.5)), t);
}

}  // namespace tribolog::history
