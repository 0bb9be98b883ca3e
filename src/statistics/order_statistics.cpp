#include "statistics/order_statistics.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <utility>

#include <boost/math/distributions/normal.hpp>

namespace tribolog::statistics {

double median(std::vector<double> values) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

double value_at_share(std::vector<double> values, double share) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  const auto at =
      values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

double range_without_ends(std::vector<double> values) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  constexpr std::size_t share = 200;
  const auto out = static_cast<std::ptrdiff_t>(values.size() / share);
  std::nth_element(values.begin(), values.begin() + out, values.end());
  const double low = values[static_cast<std::size_t>(out)];
  std::nth_element(values.begin(), values.end() - 1 - out, values.end());
  return *(values.end() - 1 - out) - low;
}

double median_interval(const std::vector<double>& rising) {
  std::vector<double> intervals;
  for (std::size_t i = 1; i < rising.size(); ++i) intervals.push_back(rising[i] - rising[i - 1]);
  return median(std::move(intervals));
}

double even_interval(const std::vector<double>& rising) {
  constexpr double of_long_gap = 2.5;
  constexpr int rounds = 3;
  const double median = median_interval(rising);
  double interval = median;
  for (int k = 0; k < rounds; ++k) {
    double sum = 0;
    double steps = 0;
    for (std::size_t i = 1; i < rising.size(); ++i) {
      const double one = rising[i] - rising[i - 1];
      if (one > of_long_gap * median) continue;
      sum += one;
      // At first all count as one step; then, by the mean, what is missing counts as two.
      steps += k == 0 ? 1 : std::max(1.0, std::round(one / interval));
    }
    interval = sum / steps;
  }
  return interval;
}

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
  constexpr Code method{"interval.bootstrap"};
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

namespace {

/// Makes Qn unbiased for few normal values (Croux and Rousseeuw 1992).
double small_sample_factor(std::size_t n) {
  constexpr double up_to_nine[] = {0, 0, 0.399, 0.994, 0.512, 0.844, 0.611, 0.857, 0.669, 0.872};
  if (n < std::size(up_to_nine)) return up_to_nine[n];
  const auto count = static_cast<double>(n);
  return count / (count + (n % 2 == 1 ? 1.4 : 3.8));
}

std::vector<double> thinned(std::vector<double> sorted) {
  constexpr std::size_t most = 400;
  if (sorted.size() <= most) return sorted;
  std::vector<double> fewer;
  for (std::size_t k = 0; k < most; ++k) {
    fewer.push_back(sorted[(2 * k + 1) * sorted.size() / (2 * most)]);
  }
  return fewer;
}

}  // namespace

double median_of(std::vector<double> values) {
  if (values.empty()) throw std::logic_error("no values");
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  if (values.size() % 2 == 1) return *middle;
  return (*middle + *std::max_element(values.begin(), middle)) / 2;
}

double pairwise_scatter(std::vector<double> values) {
  if (values.size() < 2) throw std::logic_error("no scatter");
  std::sort(values.begin(), values.end());
  values = thinned(std::move(values));
  std::vector<double> differences;
  for (std::size_t i = 0; i < values.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) differences.push_back(values[i] - values[k]);
  }
  const std::size_t half = values.size() / 2 + 1;
  const auto chosen = differences.begin() + static_cast<std::ptrdiff_t>(half * (half - 1) / 2 - 1);
  std::nth_element(differences.begin(), chosen, differences.end());
  constexpr double normal_consistency = 2.21914446598508;
  return normal_consistency * small_sample_factor(values.size()) * *chosen;
}

double scatter_freedom(std::size_t values) {
  constexpr double efficiency = 0.82;
  return efficiency * (static_cast<double>(values) - 1);
}

double deviate_of(double probability) {
  return -boost::math::quantile(boost::math::normal(), probability / 2);
}

}  // namespace tribolog::statistics
