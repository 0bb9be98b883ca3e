#include "history/change.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>

#include "statistics/student_t.h"

namespace tribolog::history {
namespace {

double chance_of(double change, double side_toward_zero) {
  if (change == 0) return 1;
  if (!(side_toward_zero > 0)) return 0;
  return std::erfc(std::abs(change) / (side_toward_zero / normal_975) / std::numbers::sqrt2);
}

}  // namespace

Change change_between(const Estimate& first, const Estimate& second, bool is_angle) {
  double change = second.value - first.value;
  if (is_angle) change = std::remainder(change, 2 * std::numbers::pi);
  const double below = std::hypot(second.value - second.low, first.high - first.value);
  const double above = std::hypot(second.high - second.value, first.value - first.low);
  Change made;
  made.absolute = {change, change - below, change + above, "independent intervals, in quadrature"};
  made.chance = chance_of(change, change > 0 ? below : above);
  const bool is_near_zero = first.value == 0 || (first.low <= 0 && first.high >= 0);
  if (!is_angle && !is_near_zero) {
    made.percent = scaled(made.absolute, 100 / std::abs(first.value));
  }
  return made;
}

std::vector<double> holm_adjusted(const std::vector<double>& chances) {
  std::vector<std::size_t> order(chances.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return chances[a] < chances[b]; });
  std::vector<double> adjusted(chances.size());
  double largest = 0;
  for (std::size_t k = 0; k < order.size(); ++k) {
    const auto left = static_cast<double>(chances.size() - k);
    largest = std::max(largest, std::min(1.0, left * chances[order[k]]));
    adjusted[order[k]] = largest;
  }
  return adjusted;
}

}  // namespace tribolog::history
