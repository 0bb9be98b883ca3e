#include "statistics/student_t.h"

#include <limits>

#include <boost/math/distributions/students_t.hpp>

namespace tribolog {

double student_t_975(double degrees_of_freedom) {
  namespace math = boost::math;
  if (!(degrees_of_freedom >= 1)) return std::numeric_limits<double>::infinity();
  // Without promotion to long double: the same digits on every machine.
  using InDouble = math::policies::policy<math::policies::promote_double<false>>;
  return math::quantile(math::students_t_distribution<double, InDouble>(degrees_of_freedom), 0.975);
}

}  // namespace tribolog
