#include "method/hysteresis/loop_midline.h"

#include <algorithm>
#include <cmath>

#include "statistics/student_t.h"

namespace tribolog {
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
void add_branches(const Recording& r, const OscillationMotion& motion, double from, double to,
                  LoopMidline& out) {
  constexpr std::size_t bins = 80;
  const HarmonicMotion joint = motion.motor_motion(1.0);
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

}  // namespace

std::optional<LoopMidline> find_loop_midline(const Recording& recording,
                                             const OscillationMotion& motion, double q_peak_rad,
                                             double white_noise_Nm) {
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
  for (int k = 0; k < static_cast<int>(out.steady_cycles); ++k) {
    const double a = first + k * period;
    const double b = std::min(t.back(), a + period);
    out.cycle_means_Nm.push_back(integral(t, recording.torque_Nm, a, b) / (b - a));
  }
  out.mean_cos = integral(t, cosine, first, last) / (last - first);
  out.mean_q_rad = integral(t, recording.q_rad, first, last) / (last - first);

  const auto n = static_cast<double>(out.cycle_means_Nm.size());
  double mean = 0;
  for (double m : out.cycle_means_Nm) mean += m / n;
  if (n >= 3) {
    double squares = 0;
    for (double m : out.cycle_means_Nm) squares += (m - mean) * (m - mean);
    const double error = std::sqrt(squares / (n - 1) / n);
    out.torque_Nm = symmetric_estimate(mean, student_t_975(n - 1) * error, "scatter of the cycles");
  } else {
    const double samples = (last - first) / sample;
    out.torque_Nm = symmetric_estimate(mean, normal_975 * white_noise_Nm / std::sqrt(samples),
                                       "white noise only: fewer than three steady cycles");
  }
  add_branches(recording, motion, first, last, out);
  return out;
}

}  // namespace tribolog
