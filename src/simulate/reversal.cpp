#include "simulate/reversal.h"

#include <cmath>
#include <limits>

#include "friction/sign_change.h"

namespace tribolog {
namespace {

/// Around a reversal: where rounding may give the speed either sign.
struct Uncertain {
  double from_s;
  double to_s;
};

/// All of [a, b] if the speeds at its ends are not of opposite sign.
Uncertain uncertain_within(const Motion& motion, double a_s, double b_s, bool negative_first) {
  const double sign = negative_first ? -1.0 : 1.0;
  const auto speed = [&](double t) { return sign * motion.speed(t); };
  if (!(speed(a_s) > 0 && speed(b_s) < 0)) return {a_s, b_s};
  const double few_units = 64 * std::numeric_limits<double>::epsilon() * std::abs(b_s);
  const double near = sign_change(speed, a_s, b_s, few_units);
  return {near - 2 * few_units, near + few_units};
}

}  // namespace

double reversal_time(const Motion& motion, double a_s, double b_s, bool negative_first) {
  const Uncertain uncertain = uncertain_within(motion, a_s, b_s, negative_first);
  double a = a_s;
  double b = b_s;
  constexpr int most_halvings = 80;
  for (int i = 0; i < most_halvings; ++i) {
    const double middle = a + (b - a) / 2;
    if (middle <= a || middle >= b) break;
    if (middle < uncertain.from_s) {
      a = middle;
    } else if (middle > uncertain.to_s) {
      b = middle;
    } else {
      const double w = motion.speed(middle);
      if (w == 0) return middle;
      ((w < 0) == negative_first ? a : b) = middle;
    }
  }
  return b;
}

}  // namespace tribolog
