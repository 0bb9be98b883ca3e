#include "method/hysteresis/loop_shape.h"

#include <algorithm>
#include <cmath>

#include "method/motion/moving_part.h"
#include "method/motion/oscillation_motion.h"
#include "statistics/distributions.h"

namespace tribolog::method::hysteresis {

double compliance(const std::vector<double>& torque_Nm, const std::vector<double>& q_rad,
                  std::size_t first, std::size_t last) {
  const auto n = static_cast<double>(last - first);
  double mean_t = 0;
  double mean_q = 0;
  for (std::size_t i = first; i < last; ++i) {
    mean_t += torque_Nm[i] / n;
    mean_q += q_rad[i] / n;
  }
  double by_t = 0;
  double by_q = 0;
  for (std::size_t i = first; i < last; ++i) {
    by_t += std::pow(torque_Nm[i] - mean_t, 2);
    by_q += (torque_Nm[i] - mean_t) * (q_rad[i] - mean_q);
  }
  return by_t > 0 ? by_q / by_t : 0;
}

statistics::Estimate stiffness_of(const std::vector<double>& values) {
  const auto n = static_cast<double>(values.size());
  double mean = 0;
  for (const double v : values) mean += v / n;
  double squares = 0;
  for (const double v : values) squares += std::pow(v - mean, 2);
  const double half = statistics::student_t_975(n - 1) * std::sqrt(squares / (n - 1) / n);
  const double share = std::min(half / mean, 0.99);
  return {1 / mean,
          1 / (mean * (1 + share)),
          1 / (mean * (1 - share)),
          {"interval.scatter_of_strokes"}};
}

std::optional<statistics::Estimate> stiffness_behind_turns(
    const std::vector<double>& q_rad, const std::vector<double>& measured_Nm,
    const std::vector<double>& torque_Nm, const std::vector<StrokeSamples>& strokes) {
  std::vector<double> all;
  for (const StrokeSamples& stroke : strokes) {
    const double start = measured_Nm[stroke.first];
    double height = 0;
    for (std::size_t i = stroke.first; i < stroke.last; ++i) {
      height = std::max(height, std::abs(measured_Nm[i] - start));
    }
    std::size_t last = stroke.first;
    while (last < stroke.last && std::abs(measured_Nm[last] - start) < part_behind_turn * height) {
      ++last;
    }
    if (last - stroke.first < fewest_samples_behind_turn) continue;
    const double c = compliance(torque_Nm, q_rad, stroke.first, last);
    if (c > 0) all.push_back(c);
  }
  if (all.size() < 2) return std::nullopt;
  return stiffness_of(all);
}

namespace {

constexpr std::size_t fewest_strokes = 2;

double interpolate(const std::vector<double>& t, const std::vector<double>& y, double at) {
  const auto it = std::lower_bound(t.begin(), t.end(), at);
  if (it == t.begin()) return y.front();
  if (it == t.end()) return y.back();
  const auto i = static_cast<std::size_t>(it - t.begin());
  const double x = (at - t[i - 1]) / (t[i] - t[i - 1]);
  return y[i - 1] + x * (y[i] - y[i - 1]);
}

struct SteadyPart {
  const joint::Recording& r;
  std::size_t first;  ///< Behind the first cycle.
  double period_s;
};

double mean_gap_rad(const SteadyPart& s) {
  double sum = 0;
  double n = 0;
  for (std::size_t i = s.first; i < s.r.size(); ++i) {
    const double before = s.r.t_s[i] - s.period_s;
    if (before < s.r.t_s[s.first]) continue;
    sum += std::abs(s.r.q_rad[i] - interpolate(s.r.t_s, s.r.q_rad, before));
    n += 1;
  }
  return n > 0 ? sum / n : 0;
}

double dissipated_per_cycle(const SteadyPart& s, double gear_ratio, double cycles) {
  const auto whole = std::floor(cycles);
  const double end = s.r.t_s[s.first] + whole * s.period_s;
  double work = 0;
  for (std::size_t i = s.first; i + 1 < s.r.size() && s.r.t_s[i + 1] <= end; ++i) {
    work += gear_ratio * (s.r.torque_Nm[i] + s.r.torque_Nm[i + 1]) / 2 *
            (s.r.q_rad[i + 1] - s.r.q_rad[i]);
  }
  return whole > 0 ? work / whole : 0;
}

/// Compliances after each reversal of the steady cycles. A reversal is the last sample at the
/// extreme angle of a half cycle about the fitted motion's own.
std::vector<double> compliances(const SteadyPart& s, const simulate::HarmonicMotion& motion,
                                double start_s, double height_Nm) {
  std::vector<double> out;
  const joint::Recording& r = s.r;
  std::size_t i = s.first;
  while (i + 1 < r.size()) {
    // A half cycle in which the fitted motion keeps its direction.
    const double direction = motion.speed(r.t_s[i] - start_s) < 0 ? -1.0 : 1.0;
    std::size_t end = i;
    while (end < r.size() && direction * motion.speed(r.t_s[end] - start_s) >= 0) ++end;
    if (end == r.size()) break;
    // The turn, looked for up to a quarter of a period behind the fitted one.
    std::size_t turn = end;
    for (std::size_t k = i; k < r.size() && r.t_s[k] < r.t_s[end] + s.period_s / 4; ++k) {
      if (direction * (r.q_rad[k] - r.q_rad[turn]) >= 0) turn = k;
    }
    std::size_t last = turn;
    while (last < r.size() &&
           direction * (r.torque_Nm[turn] - r.torque_Nm[last]) < part_behind_turn * height_Nm) {
      ++last;
    }
    if (last < r.size() && last - turn >= fewest_samples_behind_turn) {
      const double c = compliance(r.torque_Nm, r.q_rad, turn, last);
      if (c > 0) out.push_back(c);
    }
    i = end;
  }
  return out;
}

}  // namespace

std::vector<LoopShape> describe_loops(const std::vector<const joint::Recording*>& oscillations,
                                      double gear_ratio) {
  std::vector<LoopShape> shapes;
  for (const joint::Recording* whole : oscillations) {
    const joint::Recording r = motion::moving_part(*whole);
    auto motion = motion::fit_oscillation_motion(r);
    if (!motion) continue;
    // Its turns are those of three orders: higher ones, of few steps of an encoder, turn more
    // often.
    motion->harmonics.resize(std::min<std::size_t>(3, motion->harmonics.size()));
    const double period = 1 / motion->frequency_Hz;
    const auto first = static_cast<std::size_t>(
        std::lower_bound(r.t_s.begin(), r.t_s.end(), r.t_s.front() + period) - r.t_s.begin());
    if (first + 2 >= r.size()) continue;
    LoopShape shape;
    shape.recording = r.name;
    shape.cycles = (r.t_s.back() - r.t_s[first]) / period;
    if (shape.cycles < 1.99) continue;
    const SteadyPart steady{r, first, period};
    const auto begin = static_cast<std::ptrdiff_t>(first);
    const auto [q_low, q_high] = std::minmax_element(r.q_rad.begin() + begin, r.q_rad.end());
    const auto [t_low, t_high] =
        std::minmax_element(r.torque_Nm.begin() + begin, r.torque_Nm.end());
    shape.width_rad = *q_high - *q_low;
    shape.height_Nm = *t_high - *t_low;
    shape.closing_gap = mean_gap_rad(steady) / shape.width_rad;
    shape.closes = shape.closing_gap <= largest_closing_gap;
    shape.dissipated_J = dissipated_per_cycle(steady, gear_ratio, shape.cycles);
    const std::vector<double> all =
        compliances(steady, motion->motor_motion(1.0), motion->start_s, shape.height_Nm);
    shape.strokes = all.size();
    if (all.size() >= fewest_strokes) shape.stiffness_Nm_rad = stiffness_of(all);
    shapes.push_back(std::move(shape));
  }
  return shapes;
}

}  // namespace tribolog::method::hysteresis
