#include "method/hysteresis/break_away_level.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace tribolog::method::hysteresis {

namespace {

/// Part of the ramp in which the joint rests: up to where friction passes this share of the
/// reading.
constexpr double resting_share = 0.85;
constexpr std::size_t fewest_angles = 12;

/// Tf(x) = level - fall exp(-x / way), of one way.
struct BentFit {
  double level{}, fall{}, squares{INFINITY};
};

BentFit fit_bent(const std::vector<double>& x, const std::vector<double>& friction, double way) {
  double n = 0, e1 = 0, e2 = 0, f1 = 0, fe = 0, ff = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double e = std::exp(-x[i] / way);
    n += 1;
    e1 += e;
    e2 += e * e;
    f1 += friction[i];
    fe += friction[i] * e;
    ff += friction[i] * friction[i];
  }
  const double determinant = n * e2 - e1 * e1;
  if (!(determinant > 0)) return {};
  const double level = (e2 * f1 - e1 * fe) / determinant;
  const double fall = (e1 * f1 - n * fe) / determinant;
  return {level, fall, ff - level * f1 + fall * fe};
}

/// How friction bends over with travel.
struct Bend {
  double level{};
  double ways{};  ///< How many times the way of the exponential the joint travelled.
};

/// Travel and friction up to `end`, without the encoder's first step: there the joint has moved by
/// an unknown part of it; behind that, rounding changes only the height of the exponential.
struct Climb {
  std::vector<double> x, friction;

  Climb(const std::vector<double>& travel, const std::vector<double>& all, std::size_t end) {
    std::size_t moves = 0;
    while (moves < end && travel[moves] == travel.front()) ++moves;
    const auto part = [&](const std::vector<double>& of) {
      return std::vector<double>(of.begin() + static_cast<std::ptrdiff_t>(moves),
                                 of.begin() + static_cast<std::ptrdiff_t>(end));
    };
    x = part(travel);
    friction = part(all);
  }
};

/// @param shortest way that is looked for, as a share of the travel.
std::optional<Bend> bend_of(const Climb& climb, double shortest) {
  const auto& [x, friction] = climb;
  std::size_t angles = 0;
  for (std::size_t i = 1; i < x.size(); ++i) angles += x[i] != x[i - 1] ? 1 : 0;
  if (angles < fewest_angles) return std::nullopt;
  const double far = *std::max_element(x.begin(), x.end());
  // The best way on a grid, then between its neighbours.
  constexpr double straightest = 4;  // ways longer than this many travels: it does not bend
  constexpr int steps = 40;
  const auto way_at = [&](double k) {
    return far * straightest * std::pow(shortest / straightest, k / steps);
  };
  double best = 0;
  BentFit fit;
  for (int k = 0; k <= steps; ++k) {
    const BentFit one = fit_bent(x, friction, way_at(k));
    if (one.squares < fit.squares) {
      fit = one;
      best = k;
    }
  }
  double low = best - 1;
  double high = best + 1;
  for (int k = 0; k < 30; ++k) {
    const double a = low + (high - low) / 3;
    const double b = high - (high - low) / 3;
    if (fit_bent(x, friction, way_at(a)).squares < fit_bent(x, friction, way_at(b)).squares) {
      high = b;
    } else {
      low = a;
    }
  }
  const double way = way_at((low + high) / 2);
  return Bend{fit_bent(x, friction, way).level, far / way};
}

}  // namespace

std::optional<double> level_of_even_slide(const std::vector<double>& travel,
                                          const std::vector<double>& friction) {
  constexpr double fewest_ways = 6;  // all but a four-hundredth of the level
  constexpr double largest_misfit = 0.005;
  const Climb climb(travel, friction, travel.size());
  const std::optional<Bend> bend = bend_of(climb, 1.0 / 1000);
  if (!bend || bend->ways < fewest_ways || !(bend->level > 0)) return std::nullopt;
  // Friction that falls with the speed or changes with the angle has no level.
  const std::vector<double>& y = climb.friction;
  for (const std::size_t quarter : {2U, 3U}) {
    const auto begin = y.begin() + static_cast<std::ptrdiff_t>(y.size() * quarter / 4);
    const auto end = y.begin() + static_cast<std::ptrdiff_t>(y.size() * (quarter + 1) / 4);
    const double mean = std::accumulate(begin, end, 0.0) / static_cast<double>(end - begin);
    if (std::abs(mean - bend->level) > largest_misfit * bend->level) return std::nullopt;
  }
  return bend->level;
}

std::optional<double> level_at_rest(const std::vector<double>& travel,
                                    const std::vector<double>& friction, double reading) {
  // Noise crosses the share to and fro: the middle of its first and its last crossing.
  const double passed = resting_share * reading;
  std::size_t first = friction.size();
  std::size_t last = 0;
  for (std::size_t i = 0; i < friction.size(); ++i) {
    if (friction[i] > passed) first = std::min(first, i);
    if (friction[i] < passed) last = i;
  }
  const std::size_t rests = std::min((first + last) / 2, friction.size());
  constexpr double farthest = 0.3;  // share of the reading by which a level may lie off it
  const std::optional<Bend> bend = bend_of(Climb(travel, friction, rests), 1.0 / 16);
  const bool bends_over = bend && bend->ways > 1;
  if (!bends_over || !(std::abs(bend->level - reading) < farthest * reading)) return std::nullopt;
  return bend->level;
}

}  // namespace tribolog::method::hysteresis
