#include "study/found_noise.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "stages/median.h"

namespace tribolog {
namespace {

constexpr double turn = 2 * std::numbers::pi;
constexpr std::size_t most_ripples = 4;
constexpr double fewest_periods = 3;  // within the sweep
constexpr double fewest_bins = 8;     // within a period
constexpr double most_periods_per_turn = 400;
constexpr std::size_t most_bins = 4096;  // over the sweep; they bound the work
constexpr std::size_t samples_in_bin = 8;
constexpr double least_share = 0.1;  // of the ripple's variance, for a period to be put in

/// What the fit leaves, against the motor's angle: means of equal bins over both directions.
struct Leftover {
  std::vector<double> motor_rad;
  std::vector<double> torque_Nm;
};

/// Torque less the fitted curve of its direction, the curve being tabled over the angle.
Leftover leftover_of(const CogSweepResult& rough, double gear_ratio) {
  Leftover out;
  const std::vector<double>& grid = rough.fit_q_rad;
  if (grid.size() < 2) return out;
  const auto fitted = [&](const std::vector<double>& curve, double q) {
    if (curve.size() != grid.size()) return std::nan("");
    const auto after = std::upper_bound(grid.begin(), grid.end(), q);
    const auto i = static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(
        after - grid.begin() - 1, 0, static_cast<std::ptrdiff_t>(grid.size()) - 2));
    const double x = (q - grid[i]) / (grid[i + 1] - grid[i]);
    return curve[i] + x * (curve[i + 1] - curve[i]);
  };
  const std::size_t bins = std::min(most_bins, rough.samples_used / samples_in_bin);
  const double width = (rough.highest_rad - rough.lowest_rad) / static_cast<double>(bins);
  if (bins == 0 || !(width > 0)) return out;
  std::vector<double> sum(bins, 0.0);
  std::vector<double> count(bins, 0.0);
  for (std::size_t k = 0; k < rough.recordings.size(); ++k) {
    const Recording& r = *rough.recordings[k];
    constexpr std::size_t reach = 5;  // over which the direction is seen through encoder steps
    for (std::size_t i = reach; i + reach < r.size(); ++i) {
      if (!rough.used[k][i]) continue;
      const bool rising = r.q_rad[i + reach] > r.q_rad[i - reach];
      const double rest =
          r.torque_Nm[i] - fitted(rising ? rough.fit_rising_Nm : rough.fit_falling_Nm, r.q_rad[i]);
      if (!std::isfinite(rest)) continue;
      const auto bin = std::min(bins - 1, static_cast<std::size_t>(std::max(
                                              0.0, (r.q_rad[i] - rough.lowest_rad) / width)));
      sum[bin] += rest;
      count[bin] += 1;
    }
  }
  for (std::size_t bin = 0; bin < bins; ++bin) {
    if (count[bin] == 0) continue;
    out.motor_rad.push_back(gear_ratio *
                            (rough.lowest_rad + (static_cast<double>(bin) + 0.5) * width));
    out.torque_Nm.push_back(sum[bin] / count[bin]);
  }
  return out;
}

Noise::Ripple projected(const Leftover& rest, double periods_per_turn) {
  double sine = 0;
  double cosine = 0;
  for (std::size_t i = 0; i < rest.torque_Nm.size(); ++i) {
    sine += rest.torque_Nm[i] * std::sin(periods_per_turn * rest.motor_rad[i]);
    cosine += rest.torque_Nm[i] * std::cos(periods_per_turn * rest.motor_rad[i]);
  }
  const double scale = 2 / static_cast<double>(rest.torque_Nm.size());
  return {scale * std::hypot(sine, cosine), periods_per_turn, std::atan2(cosine, sine)};
}

double variance_of(const Noise::Ripple& ripple) {
  return ripple.amplitude_Nm * ripple.amplitude_Nm / 2;
}

}  // namespace

double white_torque_Nm(const std::vector<double>& torque_Nm) {
  if (torque_Nm.size() < 4) return 0;
  double squares = 0;
  std::vector<double> sizes;
  for (std::size_t i = 3; i < torque_Nm.size(); ++i) {
    const double third =
        torque_Nm[i] - 3 * torque_Nm[i - 1] + 3 * torque_Nm[i - 2] - torque_Nm[i - 3];
    squares += third * third;
    sizes.push_back(std::abs(third));
  }
  constexpr double gain = 20;                  // 1 + 9 + 9 + 1
  constexpr double normal_by_median = 1.4826;  // standard deviation by median of the size
  const double root_mean_square = std::sqrt(squares / static_cast<double>(sizes.size()));
  return std::min(root_mean_square, normal_by_median * median(std::move(sizes))) / std::sqrt(gain);
}

std::vector<Noise::Ripple> ripple_of(const CogSweepResult& rough, double gear_ratio) {
  if (!rough.found || !(rough.ripple_Nm > 0)) return {};
  const Leftover rest = leftover_of(rough, gear_ratio);
  const double range = gear_ratio * (rough.highest_rad - rough.lowest_rad);
  if (rest.torque_Nm.empty()) return {};
  const double slowest = std::ceil(fewest_periods * turn / range);
  const double bins_per_turn = static_cast<double>(rest.torque_Nm.size()) * turn / range;
  const double fastest = std::min(most_periods_per_turn, bins_per_turn / fewest_bins);
  std::vector<Noise::Ripple> all;
  for (double periods = slowest; periods <= fastest; periods += 1) {
    all.push_back(projected(rest, periods));
  }
  std::sort(all.begin(), all.end(), [](const Noise::Ripple& a, const Noise::Ripple& b) {
    return a.amplitude_Nm > b.amplitude_Nm;
  });
  const double wanted = rough.ripple_Nm * rough.ripple_Nm;
  std::vector<Noise::Ripple> kept;
  double variance = 0;
  for (const Noise::Ripple& one : all) {
    if (kept.size() == most_ripples || variance_of(one) < least_share * wanted) break;
    kept.push_back(one);
    variance += variance_of(one);
  }
  for (Noise::Ripple& one : kept) one.amplitude_Nm *= std::sqrt(wanted / variance);
  return kept;
}

}  // namespace tribolog
