#include "method/hysteresis/loop_points.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Core>

#include "statistics/distributions.h"
#include "statistics/linear_systems.h"
#include "statistics/sampled_signal.h"

namespace tribolog::method::hysteresis {

namespace {

/// Integral of a sampled signal over [a, b] by the trapezoidal rule, ends interpolated.
double integral(const std::vector<double>& t, const std::vector<double>& y, double a, double b) {
  const auto value_at = [&](double time) {
    const auto after = std::upper_bound(t.begin(), t.end(), time);
    const auto i = std::clamp<std::ptrdiff_t>(after - t.begin() - 1, 0,
                                              static_cast<std::ptrdiff_t>(t.size()) - 2);
    const auto k = static_cast<std::size_t>(i);
    const double x = std::clamp((time - t[k]) / (t[k + 1] - t[k]), 0.0, 1.0);
    return y[k] + x * (y[k + 1] - y[k]);
  };
  double sum = 0;
  double last_t = a;
  double last_y = value_at(a);
  for (auto it = std::upper_bound(t.begin(), t.end(), a); it != t.end() && *it < b; ++it) {
    const double y_i = y[static_cast<std::size_t>(it - t.begin())];
    sum += (y_i + last_y) / 2 * (*it - last_t);
    last_t = *it;
    last_y = y_i;
  }
  return sum + (value_at(b) + last_y) / 2 * (b - last_t);
}

/// (rising + falling)/2 over equal bins of the angle, from the steady samples.
void add_branches(const joint::Recording& r, const motion::OscillationMotion& motion, double from,
                  double to, LoopMidline& out) {
  constexpr std::size_t bins = 80;
  const simulate::HarmonicMotion joint = motion.motor_motion(1.0);
  const double low = motion.centre_rad - motion.amplitude_rad;
  const double width = 2 * motion.amplitude_rad / static_cast<double>(bins);
  std::vector<double> sum[2] = {std::vector<double>(bins, 0.0), std::vector<double>(bins, 0.0)};
  std::vector<double> count[2] = {std::vector<double>(bins, 0.0), std::vector<double>(bins, 0.0)};
  for (std::size_t i = 0; i < r.size(); ++i) {
    if (r.t_s[i] < from || r.t_s[i] >= to) continue;
    const double t = r.t_s[i] - motion.start_s;
    const double place = std::floor((joint.angle(t) - low) / width);
    if (place < 0 || place >= static_cast<double>(bins)) continue;
    const auto bin = static_cast<std::size_t>(place);
    const int branch = joint.speed(t) > 0 ? 0 : 1;
    sum[branch][bin] += r.torque_Nm[i];
    count[branch][bin] += 1;
  }
  for (std::size_t bin = 0; bin < bins; ++bin) {
    if (count[0][bin] == 0 || count[1][bin] == 0) continue;
    out.q_rad.push_back(low + (static_cast<double>(bin) + 0.5) * width);
    out.midline_Nm.push_back((sum[0][bin] / count[0][bin] + sum[1][bin] / count[1][bin]) / 2);
  }
}

/// Share of the correction by the mean over the angle that is not trusted: friction does depend on
/// speed a little.
constexpr double distrust_of_angle_mean = 0.1;

/// |dq/dt| of the motion at the samples.
std::vector<double> way_weights(const joint::Recording& r,
                                const motion::OscillationMotion& motion) {
  const simulate::HarmonicMotion joint = motion.motor_motion(1.0);
  std::vector<double> weights(r.size());
  for (std::size_t i = 0; i < r.size(); ++i) {
    weights[i] = std::abs(joint.speed(r.t_s[i] - motion.start_s));
  }
  return weights;
}

std::vector<double> product(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> out(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) out[i] = a[i] * b[i];
  return out;
}

}  // namespace

std::optional<LoopMidline> find_loop_midline(const joint::Recording& recording,
                                             const motion::OscillationMotion& motion,
                                             double q_peak_rad, double white_noise_Nm) {
  LoopMidline out;
  const auto& t = recording.t_s;
  const double period = 1 / motion.frequency_Hz;
  const double sample = (t.back() - t.front()) / static_cast<double>(t.size() - 1);
  const double whole = std::floor((t.back() - t.front() + 0.1 * sample) / period);
  if (whole < 1) return std::nullopt;
  out.cycles = whole;
  out.start_up_included = whole < 2;
  const double first = out.start_up_included ? t.front() : t.front() + period;
  out.steady_cycles = out.start_up_included ? whole : whole - 1;

  std::vector<double> cosine(t.size());
  for (std::size_t i = 0; i < t.size(); ++i) {
    cosine[i] = std::cos(recording.q_rad[i] - q_peak_rad);
  }
  const double last = std::min(t.back(), first + out.steady_cycles * period);
  out.by_angle = motion.has_even_harmonics();
  std::vector<double> weights;
  std::vector<double> weighted;
  if (out.by_angle) {
    weights = way_weights(recording, motion);
    weighted = product(weights, recording.torque_Nm);
  }
  double by_time = 0;
  for (int k = 0; k < static_cast<int>(out.steady_cycles); ++k) {
    const double a = first + k * period;
    const double b = std::min(t.back(), a + period);
    const double mean_in_time = integral(t, recording.torque_Nm, a, b) / (b - a);
    by_time += mean_in_time / out.steady_cycles;
    out.cycle_means_Nm.push_back(
        out.by_angle ? integral(t, weighted, a, b) / integral(t, weights, a, b) : mean_in_time);
  }
  out.mean_cos = out.by_angle ? integral(t, product(weights, cosine), first, last) /
                                    integral(t, weights, first, last)
                              : integral(t, cosine, first, last) / (last - first);
  out.mean_q_rad = integral(t, recording.q_rad, first, last) / (last - first);

  const auto n = static_cast<double>(out.cycle_means_Nm.size());
  double mean = 0;
  for (double m : out.cycle_means_Nm) mean += m / n;
  if (n >= 3) {
    double squares = 0;
    for (double m : out.cycle_means_Nm) squares += (m - mean) * (m - mean);
    const double error = std::sqrt(squares / (n - 1) / n);
    out.torque_Nm = statistics::symmetric_estimate(mean, statistics::student_t_975(n - 1) * error,
                                                   {"interval.scatter_of_cycles"});
  } else {
    const double samples = (last - first) / sample;
    out.torque_Nm = statistics::symmetric_estimate(
        mean, statistics::normal_975 * white_noise_Nm / std::sqrt(samples),
        {"interval.white_noise_only"});
  }
  if (out.by_angle) {
    const double untrusted = distrust_of_angle_mean * std::abs(mean - by_time);
    out.torque_Nm = statistics::symmetric_estimate(
        mean, std::hypot(out.torque_Nm.half_width(), untrusted),
        {"interval.mean_over_angle", {{"interval", out.torque_Nm.method}}});
  }
  std::vector<double> distance(t.size());
  for (std::size_t i = 0; i < t.size(); ++i) distance[i] = std::abs(recording.torque_Nm[i] - mean);
  out.friction_Nm = integral(t, distance, first, last) / (last - first);
  add_branches(recording, motion, first, last, out);
  return out;
}

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

LoopPoint loop_point(const LoopTrace& trace, const TraceReader& reader, Estimator name,
                     double time_s) {
  const TorqueReading torque = reader.torque(time_s);
  return {name,
          time_s,
          reader.interpolate(trace.q_rad, time_s),
          torque.value_Nm,
          torque.value_Nm - torque.half_width_Nm,
          torque.value_Nm + torque.half_width_Nm,
          reader.interpolate(trace.z_rad, time_s),
          reader.interpolate(trace.dz_rad_s, time_s)};
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
      noise_Nm_(statistics::white_sd_beside_jumps(statistics::third_differences(trace.torque_Nm))) {
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
  if (end - begin < 6)
    return {interpolate(trace_.torque_Nm, t_s), statistics::normal_975 * noise_Nm_};
  Eigen::MatrixXd x(end - begin, 3);
  Eigen::VectorXd y(end - begin);
  for (auto i = begin; i < end; ++i) {
    const double d = (t[static_cast<std::size_t>(i)] - t_s) / window_s_;
    x.row(i - begin) << 1, d, d * d;
    y(i - begin) = trace_.torque_Nm[static_cast<std::size_t>(i)];
  }
  const Eigen::Matrix3d inverse = statistics::inverse_normal(x);
  const double value = (inverse * (x.transpose() * y))(0);
  return {value, statistics::normal_975 * noise_Nm_ * std::sqrt(inverse(0, 0))};
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
  const auto point = [&](Estimator name, double time) {
    return loop_point(trace, reader, name, time);
  };
  return std::vector<LoopPoint>{point(Estimator::A, cubic_crossing(t, z, dz, a)),
                                point(Estimator::B, cubic_crossing(t, z, dz, b)),
                                point(Estimator::C, turning_time(c)),
                                point(Estimator::D, turning_time(d)),
                                point(Estimator::E, extremum_time(t, dz, e)),
                                point(Estimator::F, extremum_time(t, dz, f))};
}

void put_half_a_period_apart(const LoopTrace& trace, const TraceReader& reader, double period_s,
                             std::vector<LoopPoint>& points) {
  const auto named = [&](Estimator name) {
    return std::find_if(points.begin(), points.end(),
                        [&](const LoopPoint& point) { return point.name == name; });
  };
  const auto e = named(Estimator::E);
  const auto f = named(Estimator::F);
  const double middle_s = (e->t_s + f->t_s) / 2;
  *f = loop_point(trace, reader, Estimator::F, middle_s - period_s / 4);
  *e = loop_point(trace, reader, Estimator::E, middle_s + period_s / 4);
}

}  // namespace tribolog::method::hysteresis
