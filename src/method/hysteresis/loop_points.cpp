#include "method/hysteresis/loop_points.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Dense>

#include "statistics/student_t.h"
#include "statistics/white_noise.h"

namespace tribolog {
namespace {

/// Time in [i, i+1] at which a signal crosses zero, by the chord.
double chord_crossing(const std::vector<double>& t, const std::vector<double>& y, std::size_t i) {
  const double step = y[i] - y[i + 1];
  return step == 0 ? t[i] : t[i] + (t[i + 1] - t[i]) * y[i] / step;
}

/// Time in [i, i+1] at which z crosses zero, by the cubic through z and its rate at both ends.
double cubic_crossing(const std::vector<double>& t, const std::vector<double>& z,
                      const std::vector<double>& dz, std::size_t i) {
  const double h = t[i + 1] - t[i];
  const auto value = [&](double x) {
    const double y = 1 - x;
    return y * y * (1 + 2 * x) * z[i] + x * x * (3 - 2 * x) * z[i + 1] +
           h * x * y * (y * dz[i] - x * dz[i + 1]);
  };
  double low = 0;
  double high = 1;
  const bool rising = z[i + 1] > z[i];
  for (int k = 0; k < 60; ++k) {
    const double middle = (low + high) / 2;
    ((value(middle) < 0) == rising ? low : high) = middle;
  }
  return z[i] == 0 ? t[i] : t[i] + h * (low + high) / 2;
}

/// Time of the extremum around sample i, by the parabola through it and its neighbours.
double extremum_time(const std::vector<double>& t, const std::vector<double>& y, std::size_t i) {
  if (i == 0 || i + 1 >= y.size()) return t[i];
  const double curvature = y[i - 1] - 2 * y[i] + y[i + 1];
  if (curvature == 0) return t[i];
  const double shift = std::clamp((y[i - 1] - y[i + 1]) / (2 * curvature), -1.0, 1.0);
  return t[i] + shift * (t[i + 1] - t[i - 1]) / 2;
}

}  // namespace

TraceReader::TraceReader(const LoopTrace& trace, double period_s)
    : trace_(trace),
      window_s_(0.01 * period_s),
      noise_Nm_(white_sd_beside_jumps(third_differences(trace.torque_Nm))) {
  const auto [low, high] = std::minmax_element(trace.torque_Nm.begin(), trace.torque_Nm.end());
  is_clean_ = noise_Nm_ < 1e-4 * (*high - *low);
}

std::size_t TraceReader::interval_of(double t_s) const {
  const auto& t = trace_.t_s;
  const auto after = std::upper_bound(t.begin(), t.end(), t_s);
  const auto i = static_cast<std::size_t>(std::max<std::ptrdiff_t>(1, after - t.begin())) - 1;
  return std::min(i, t.size() - 2);
}

double TraceReader::interpolate(const std::vector<double>& signal, double t_s) const {
  const std::size_t i = interval_of(t_s);
  const double x = (t_s - trace_.t_s[i]) / (trace_.t_s[i + 1] - trace_.t_s[i]);
  return signal[i] + x * (signal[i + 1] - signal[i]);
}

double TraceReader::smooth_torque(double t_s) const {
  const std::size_t n = trace_.t_s.size();
  const std::size_t i = interval_of(t_s);
  const bool on_sample = t_s == trace_.t_s[i] || t_s == trace_.t_s[i + 1];
  if (n < 4 || on_sample) return interpolate(trace_.torque_Nm, t_s);
  const std::size_t first = std::min(i == 0 ? 0 : i - 1, n - 4);
  double sum = 0;
  for (std::size_t k = first; k < first + 4; ++k) {
    double weight = 1;
    for (std::size_t m = first; m < first + 4; ++m) {
      if (m != k) weight *= (t_s - trace_.t_s[m]) / (trace_.t_s[k] - trace_.t_s[m]);
    }
    sum += weight * trace_.torque_Nm[k];
  }
  return sum;
}

TorqueReading TraceReader::torque(double t_s) const {
  if (is_clean_) return {smooth_torque(t_s), 0.0};
  const auto& t = trace_.t_s;
  const auto begin = std::lower_bound(t.begin(), t.end(), t_s - window_s_) - t.begin();
  const auto end = std::upper_bound(t.begin(), t.end(), t_s + window_s_) - t.begin();
  if (end - begin < 6) return {interpolate(trace_.torque_Nm, t_s), normal_975 * noise_Nm_};
  Eigen::MatrixXd x(end - begin, 3);
  Eigen::VectorXd y(end - begin);
  for (auto i = begin; i < end; ++i) {
    const double d = (t[static_cast<std::size_t>(i)] - t_s) / window_s_;
    x.row(i - begin) << 1, d, d * d;
    y(i - begin) = trace_.torque_Nm[static_cast<std::size_t>(i)];
  }
  const Eigen::Matrix3d inverse = (x.transpose() * x).inverse();
  const double value = (inverse * (x.transpose() * y))(0);
  return {value, normal_975 * noise_Nm_ * std::sqrt(inverse(0, 0))};
}

std::optional<std::vector<LoopPoint>> find_loop_points(const LoopTrace& trace,
                                                       const TraceReader& reader, std::size_t first,
                                                       std::size_t& next) {
  const auto& z = trace.z_rad;
  const auto& dz = trace.dz_rad_s;
  const auto& t = trace.t_s;
  const std::size_t n = t.size();
  const auto up = [&](std::size_t i) { return z[i] <= 0 && z[i + 1] > 0; };
  const auto down = [&](std::size_t i) { return z[i] >= 0 && z[i + 1] < 0; };
  std::size_t a = first;
  while (a + 1 < n && !up(a)) ++a;
  std::size_t b = a + 1;
  while (b + 1 < n && !down(b)) ++b;
  std::size_t a2 = b + 1;
  while (a2 + 1 < n && !up(a2)) ++a2;
  if (a2 >= n) return std::nullopt;
  const bool whole = a2 + 1 < n;
  const auto index = [](auto it, const auto& v) {
    return static_cast<std::size_t>(it - v.begin());
  };
  const auto at = [](const auto& v, std::size_t i) {
    return v.begin() + static_cast<std::ptrdiff_t>(i);
  };
  const std::size_t c = index(std::max_element(at(z, a), at(z, b + 1)), z);
  const std::size_t f = index(std::min_element(at(dz, c), at(dz, b + 1)), dz);
  const std::size_t d = index(std::min_element(at(z, b), at(z, std::min(a2 + 1, n))), z);
  const std::size_t e = index(std::max_element(at(dz, d), at(dz, std::min(a2 + 1, n))), dz);
  // Without the closing zero the turn must at least have come back far enough to show E.
  if (!whole && (e + 2 >= n || d + 2 >= n)) return std::nullopt;
  next = a2;

  // At its extremes z turns where its rate changes sign, often with a kink: read there.
  const auto turning_time = [&](std::size_t i) {
    for (const std::size_t k : {i == 0 ? 0 : i - 1, i}) {
      if (k + 1 < n && dz[k] * dz[k + 1] < 0) return chord_crossing(t, dz, k);
    }
    return t[i];
  };
  const auto point = [&](char name, double time) {
    const TorqueReading torque = reader.torque(time);
    return LoopPoint{name,
                     time,
                     reader.interpolate(trace.q_rad, time),
                     torque.value_Nm,
                     torque.value_Nm - torque.half_width_Nm,
                     torque.value_Nm + torque.half_width_Nm,
                     reader.interpolate(z, time),
                     reader.interpolate(dz, time)};
  };
  return std::vector<LoopPoint>{point('A', cubic_crossing(t, z, dz, a)),
                                point('B', cubic_crossing(t, z, dz, b)),
                                point('C', turning_time(c)),
                                point('D', turning_time(d)),
                                point('E', extremum_time(t, dz, e)),
                                point('F', extremum_time(t, dz, f))};
}

}  // namespace tribolog
