#include "statistics/sampled_signal.h"

#include <algorithm>
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

std::size_t half_window_of_slope(std::size_t samples) {
  constexpr std::size_t windows_in_recording = 500;
  constexpr std::size_t least = 3;
  return std::max(least, samples / windows_in_recording / 2);
}

std::vector<double> local_slope(const std::vector<double>& t, const std::vector<double>& y,
                                std::size_t h) {
  // By prefix sums.
  const std::size_t n = t.size();
  std::vector<double> sum_t(n + 1, 0.0);
  std::vector<double> sum_y(n + 1, 0.0);
  for (std::size_t i = 0; i < n; ++i) {
    sum_t[i + 1] = sum_t[i] + (t[i] - t[0]);
    sum_y[i + 1] = sum_y[i] + (y[i] - y[0]);
  }
  std::vector<double> slope(n, 0.0);
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t centre = std::clamp(i, std::min<std::size_t>(1, n - 1), n - 1);
    const std::size_t left = std::min(h, centre);
    const std::size_t right = std::min(h, n - centre);
    if (left == 0 || right == 0) continue;
    const double dl = static_cast<double>(left);
    const double dr = static_cast<double>(right);
    const double dt =
        (sum_t[centre + right] - sum_t[centre]) / dr - (sum_t[centre] - sum_t[centre - left]) / dl;
    const double dy =
        (sum_y[centre + right] - sum_y[centre]) / dr - (sum_y[centre] - sum_y[centre - left]) / dl;
    slope[i] = dt > 0 ? dy / dt : 0.0;
  }
  return slope;
}

std::vector<double> local_curvature(const std::vector<double>& t, const std::vector<double>& y,
                                    std::size_t h) {
  std::vector<double> curvature = local_slope(t, local_slope(t, y, h), h);
  if (!curvature.empty()) curvature.erase(curvature.begin());
  curvature.resize(y.size(), curvature.empty() ? 0.0 : curvature.back());
  return curvature;
}

double cut_off_of_slope_Hz(std::size_t h, double interval_s) {
  constexpr double at_half_power = 0.318917;  // sinc^2(x) = 1/sqrt(2)
  return at_half_power / (static_cast<double>(h) * interval_s);
}

void low_pass(std::span<double> signal, double time_constant) {
  if (!(time_constant > 0) || signal.empty()) return;
  const double fade = std::exp(-1 / time_constant);
  double lacks = 0;  // of the signal's value
  double before = signal.front();
  for (double& value : signal) {
    const double settled = (value - before) * time_constant;
    lacks = settled + (lacks - settled) * fade;
    before = value;
    value -= lacks;
  }
}

void moving_mean(std::span<double> signal, double width) {
  if (!(width > 0) || signal.empty()) return;
  std::vector<double> values(signal.begin(), signal.end());
  std::vector<double> sum{0};  // integral up to each sample
  for (std::size_t i = 1; i < values.size(); ++i) {
    sum.push_back(sum.back() + (values[i - 1] + values[i]) / 2);
  }
  const auto up_to = [&](double at) {
    if (at <= 0) return values.front() * at;
    const auto below = std::min(static_cast<std::size_t>(at), values.size() - 1);
    const double share = at - static_cast<double>(below);
    if (share == 0) return sum[below];
    const double rise = values[below + 1] - values[below];
    return sum[below] + share * (values[below] + share * rise / 2);
  };
  for (std::size_t i = 0; i < values.size(); ++i) {
    signal[i] = (sum[i] - up_to(static_cast<double>(i) - width)) / width;
  }
}

}  // namespace tribolog::statistics
