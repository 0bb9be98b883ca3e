#include "statistics/estimate.h"

#include <algorithm>
#include <cmath>

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

std::string to_string(StageState state) {
  switch (state) {
    case StageState::done:
      return "done";
    case StageState::partial:
      return "partial";
    case StageState::not_identifiable:
      return "not_identifiable";
    case StageState::skipped:
      return "skipped";
  }
  return "unknown";
}

}  // namespace tribolog::statistics
