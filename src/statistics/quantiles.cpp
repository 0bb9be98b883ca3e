#include "statistics/quantiles.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace tribolog::bootstrap {
namespace {

/// Linear between the order statistics; reorders the values.
double quantile(std::vector<double>& values, double share) {
  const double place = share * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(below);
  std::nth_element(values.begin(), at, values.end());
  const double low = *at;
  if (below + 1 == values.size()) return low;
  const double high = *std::min_element(at + 1, values.end());
  return low + (place - static_cast<double>(below)) * (high - low);
}

}  // namespace

Estimate percentile_interval(double estimate, std::vector<double> values) {
  constexpr double most_lost = 0.05;
  const auto all = static_cast<double>(values.size());
  std::erase_if(values, [](double v) { return !std::isfinite(v); });
  const char* method = "bootstrap";
  if (values.empty() || static_cast<double>(values.size()) < (1 - most_lost) * all) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    return {estimate, -infinity, infinity, method};
  }
  const double low = quantile(values, 0.025);
  const double high = quantile(values, 0.975);
  return {estimate, std::min(low, estimate), std::max(high, estimate), method};
}

Estimate root_mean_square_interval(double estimate, std::vector<double> values) {
  double mean = 0;
  for (double& v : values) {
    v *= v;
    mean += v / static_cast<double>(values.size());
  }
  const double square = estimate * estimate;
  const double noise = std::max(0.0, mean - square);
  const Estimate squares = percentile_interval(square, std::move(values));
  const auto root = [&](double end) { return std::sqrt(std::max(0.0, end - 2 * noise)); };
  return {estimate, std::min(estimate, root(squares.low)), std::max(estimate, root(squares.high)),
          squares.method};
}

}  // namespace tribolog::bootstrap
