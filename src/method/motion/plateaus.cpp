#include "method/motion/plateaus.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "statistics/order_statistics.h"
#include "statistics/sampled_signal.h"

namespace tribolog::method::motion {

namespace {

/// Noise of the local slope, from second differences over disjoint windows: a steady speed, a ramp
/// and a slow sine all drop out.
double slope_noise(const std::vector<double>& v, std::size_t window, double rest) {
  std::vector<double> differences;
  for (std::size_t i = window; i + window < v.size(); i += std::max<std::size_t>(1, window / 2)) {
    if (std::abs(v[i]) < rest) continue;
    differences.push_back(std::abs(v[i + window] - 2 * v[i] + v[i - window]));
  }
  if (differences.empty()) return 0;
  return statistics::normal_sd_by_median_size * statistics::median(std::move(differences)) /
         std::sqrt(6.0);
}

/// The stretch [first, last) without the ends of its ramps: trimmed until the speed is that of the
/// middle half, within its noise. A speed that differs over a tenth of the stretch or more is a
/// drift, not a ramp: that much is tolerated.
std::pair<std::size_t, std::size_t> steady_part(const std::vector<double>& v, std::size_t first,
                                                std::size_t last, double noise) {
  constexpr double tight = 1e-3;
  constexpr double loosest = 0.02;
  const std::size_t quarter = (last - first) / 4;
  const auto at = [&](std::size_t i) { return v.begin() + static_cast<std::ptrdiff_t>(i); };
  const double speed = statistics::median({at(first + quarter), at(last - quarter)});
  const std::size_t longest_ramp = (last - first) / 10;
  const auto ramp = [&](auto speed_at) {
    std::size_t length = 0;
    for (double share = tight; share <= loosest; share *= 2) {
      const double tolerance = std::max(share * std::abs(speed), 4 * noise);
      length = 0;
      while (length < last - first && std::abs(speed_at(length) - speed) > tolerance) ++length;
      if (length <= longest_ramp) break;
    }
    return length;
  };
  const std::size_t begin = ramp([&](std::size_t k) { return v[first + k]; });
  const std::size_t end = ramp([&](std::size_t k) { return v[last - 1 - k]; });
  if (begin + end >= last - first) return {first, first};
  first += begin;
  last -= end;
  return {first, last};
}

/// Whether a plateau is the crest of a drive's overshoot: beside a much longer one of the same
/// stroke at nearly its speed.
bool is_overshoot(const Plateau& one, const Plateau& beside, const std::vector<double>& v,
                  double rest) {
  constexpr std::size_t times_longer = 3;
  constexpr double nearly = 0.15;
  if (beside.size() < times_longer * one.size()) return false;
  if (std::abs(one.speed_rad_s / beside.speed_rad_s - 1) > nearly) return false;
  const auto at = [&](std::size_t i) { return v.begin() + static_cast<std::ptrdiff_t>(i); };
  return std::all_of(at(std::min(one.last, beside.last)), at(std::max(one.first, beside.first)),
                     [&](double speed) { return std::abs(speed) > rest; });
}

/// Takes them off the plateaus.
void leave_out_overshoots(MotionSegments& motion, double rest) {
  const std::vector<Plateau> all = std::move(motion.plateaus);
  motion.plateaus.clear();
  for (std::size_t k = 0; k < all.size(); ++k) {
    const auto of = [&](std::size_t other) {
      return is_overshoot(all[k], all[other], motion.speed_rad_s, rest);
    };
    if ((k > 0 && of(k - 1)) || (k + 1 < all.size() && of(k + 1))) {
      motion.samples_on_plateaus -= all[k].size();
      motion.samples_trimmed += all[k].size();
    } else {
      motion.plateaus.push_back(all[k]);
    }
  }
}

}  // namespace

double MotionSegments::plateau_share() const {
  const std::size_t moving = samples_on_plateaus + samples_trimmed + samples_accelerating;
  return moving == 0 ? 0.0
                     : static_cast<double>(samples_on_plateaus + samples_trimmed) /
                           static_cast<double>(moving);
}

MotionSegments find_plateaus(const joint::Recording& recording, const PlateauOptions& options) {
  MotionSegments out;
  const std::size_t n = recording.size();
  if (n < 8) {
    out.speed_rad_s.assign(n, 0.0);
    out.acceleration_rad_s2.assign(n, 0.0);
    out.samples_at_rest = n;
    return out;
  }
  const std::size_t h = statistics::half_window_of_slope(n);
  out.window = 2 * h;
  out.speed_rad_s = statistics::local_slope(recording.t_s, recording.q_rad, h);
  out.acceleration_rad_s2 = statistics::local_slope(recording.t_s, out.speed_rad_s, h);
  const std::vector<double>& v = out.speed_rad_s;
  // A single wild sample must not set the scale.
  std::vector<double> magnitudes(n);
  std::transform(v.begin(), v.end(), magnitudes.begin(), [](double x) { return std::abs(x); });
  const std::size_t rank = n - 1 - n / 1000;
  std::nth_element(magnitudes.begin(), magnitudes.begin() + static_cast<std::ptrdiff_t>(rank),
                   magnitudes.end());
  out.fastest_rad_s = magnitudes[rank];
  const double rest = options.rest_share * out.fastest_rad_s;
  const double noise = slope_noise(v, 2 * h, rest);
  const auto shortest =
      std::max(options.fewest_samples,
               static_cast<std::size_t>(options.shortest_share * static_cast<double>(n)));
  const auto tolerance = [&](double speed) {
    constexpr double widest = 0.1;
    return std::max(options.tolerance * speed, std::min(widest * speed, 4 * noise));
  };

  for (std::size_t i = 0; i < n;) {
    if (std::abs(v[i]) <= rest) {
      ++out.samples_at_rest;
      ++i;
      continue;
    }
    double sum = 0;
    std::size_t end = i;
    while (end < n && std::abs(v[end]) > rest) {
      const double mean = end == i ? v[i] : sum / static_cast<double>(end - i);
      if (std::abs(v[end] - mean) > tolerance(std::abs(mean))) break;
      sum += v[end];
      ++end;
    }
    const auto [steady_first, steady_last] = steady_part(v, i, end, noise);
    const std::size_t length = steady_last - steady_first;
    const std::size_t settling = std::max(2 * h, length / 20);
    if (length < shortest + 2 * settling) {
      const std::size_t skip = std::max<std::size_t>(1, (end - i) / 8);
      out.samples_accelerating += skip;
      i += skip;
      continue;
    }
    Plateau plateau{steady_first + settling, steady_last - settling, 0.0};
    plateau.speed_rad_s = (recording.q_rad[plateau.last - 1] - recording.q_rad[plateau.first]) /
                          (recording.t_s[plateau.last - 1] - recording.t_s[plateau.first]);
    out.samples_on_plateaus += plateau.size();
    out.samples_trimmed += end - i - plateau.size();
    out.plateaus.push_back(plateau);
    i = end;
  }
  leave_out_overshoots(out, rest);
  return out;
}

std::vector<SpeedSource> speed_sources(const std::vector<joint::Recording>& recordings) {
  std::vector<SpeedSource> sources;
  for (const joint::Recording& r : recordings) {
    if (r.size() < 2) continue;
    const double interval_s = statistics::median_interval(r.t_s);
    const std::size_t h = statistics::half_window_of_slope(r.size());
    sources.push_back({r.name, r.role, !r.dq_rad_s.empty(), 2 * h,
                       static_cast<double>(2 * h) * interval_s,
                       statistics::cut_off_of_slope_Hz(h, interval_s)});
  }
  return sources;
}

}  // namespace tribolog::method::motion
