#include "statistics/estimate.h"

#include <algorithm>
#include <cmath>

#include "base/enum_text.h"

namespace tribolog::statistics {

Estimate symmetric_estimate(double value, double half_width, Statement method) {
  const double h = std::abs(half_width);
  return {value, value - h, value + h, std::move(method)};
}

Estimate scaled(const Estimate& estimate, double factor) {
  const double a = estimate.low * factor;
  const double b = estimate.high * factor;
  return {estimate.value * factor, std::min(a, b), std::max(a, b), estimate.method};
}

std::string to_string(StageState state) { return own_name(state); }

}  // namespace tribolog::statistics
