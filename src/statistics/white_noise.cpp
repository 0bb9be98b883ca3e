#include "statistics/white_noise.h"

#include <cmath>
#include <cstddef>
#include <utility>

#include "statistics/order_statistics.h"

namespace tribolog::statistics {
namespace {

constexpr double gain = 20;  // 1 + 9 + 9 + 1

}  // namespace

double third_difference(const double* y) { return y[3] - 3 * y[2] + 3 * y[1] - y[0]; }

std::vector<double> third_differences(const std::vector<double>& signal) {
  std::vector<double> third;
  for (std::size_t i = 3; i < signal.size(); ++i) third.push_back(third_difference(&signal[i - 3]));
  return third;
}

double white_variance(const std::vector<double>& third_differences) {
  if (third_differences.empty()) return 0;
  double squares = 0;
  for (const double third : third_differences) squares += third * third;
  return squares / (gain * static_cast<double>(third_differences.size()));
}

double white_sd_beside_jumps(std::vector<double> third_differences) {
  if (third_differences.empty()) return 0;
  for (double& third : third_differences) third = std::abs(third);
  return normal_sd_by_median_size * median(std::move(third_differences)) / std::sqrt(gain);
}

}  // namespace tribolog::statistics
