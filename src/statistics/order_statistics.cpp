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
