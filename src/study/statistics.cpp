#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>

#include "statistics/distributions.h"
#include "study/study.h"

namespace tribolog::study {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double lowest_honest = 0.91;
constexpr double highest_honest = 0.99;

}  // namespace

Share wilson_share(std::size_t hits, std::size_t trials) {
  if (trials == 0 || hits > trials) {
    throw std::invalid_argument(
        fmt::format("{} hits of {} trials are not allowed; hits must be <= trials, and there must "
                    "be a trial",
                    hits, trials));
  }
  const auto n = static_cast<double>(trials);
  const double p = static_cast<double>(hits) / n;
  const double z2 = statistics::normal_975 * statistics::normal_975;
  const double centre = (p + z2 / (2 * n)) / (1 + z2 / n);
  const double reach =
      statistics::normal_975 / (1 + z2 / n) * std::sqrt(p * (1 - p) / n + z2 / (4 * n * n));
  return {p, std::clamp(centre - reach, 0.0, p), std::clamp(centre + reach, p, 1.0)};
}

bool ErrorStatistics::is_biased(double practical_bound) const {
  return std::abs(bias) > 3 * bias_standard_error && std::abs(bias) > practical_bound;
}

bool ErrorStatistics::all_alike() const {
  constexpr double rounding = 1e-12;
  return scatter <= rounding * std::abs(truth);
}

bool ErrorStatistics::intervals_too_narrow() const {
  return found > 0 && coverage.high < lowest_honest;
}

bool ErrorStatistics::intervals_too_wide() const {
  return found > 0 && coverage.low > highest_honest;
}

ErrorStatistics error_statistics(const std::vector<statistics::Estimate>& estimates, double truth,
                                 std::size_t runs) {
  ErrorStatistics out{runs, estimates.size(), truth, nan, nan, nan, nan, nan, {nan, nan, nan}};
  if (estimates.empty()) return out;
  const auto n = static_cast<double>(estimates.size());
  std::vector<double> sizes;
  double sum = 0;
  double width = 0;
  std::size_t inside = 0;
  for (const statistics::Estimate& e : estimates) {
    sum += e.value - truth;
    width += e.half_width();
    inside += e.low <= truth && truth <= e.high ? 1 : 0;
    sizes.push_back(std::abs(e.value - truth));
  }
  out.bias = sum / n;
  out.half_width = width / n;
  out.coverage = wilson_share(inside, estimates.size());
  std::sort(sizes.begin(), sizes.end());
  out.error_95 = sizes[static_cast<std::size_t>(std::ceil(0.95 * n)) - 1];
  if (estimates.size() < 2) return out;
  double squares = 0;
  for (const statistics::Estimate& e : estimates)
    squares += std::pow(e.value - truth - out.bias, 2);
  out.scatter = std::sqrt(squares / (n - 1));
  out.bias_standard_error = out.scatter / std::sqrt(n);
  return out;
}

}  // namespace tribolog::study
