#include "method/gravity/residual_causes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace tribolog::method::gravity {
namespace {

using std::numbers::pi;

constexpr std::size_t most_lines_in_all = 8;
constexpr double least_line_share = 0.02;  // of the variance, for a line
/// A motor that makes fewer turns in the sweep shows no ripple of one period a turn.
constexpr double fewest_turns = 3;

/// There and back at one speed, what changes with the angle is of a period in time too where the
/// phase happens to be so: one over the time has to carry more.
constexpr double stronger_over_time = 1.02;

enum class Over { angle, angle_by_direction, time };

/// One spectrum: where its samples lie, and how it is searched. Over time a "turn" is a second.
struct Spectrum {
  Over over;
  std::vector<double> place_rad;
  RippleSearch search;

  [[nodiscard]] double turns() const {
    const auto [low, high] = std::minmax_element(place_rad.begin(), place_rad.end());
    return (*high - *low) / (2 * pi);
  }
};

Spectrum over_angle(const motion::Sweep& sweep, double gear_ratio, Over over) {
  Spectrum s{over, {}, {}};
  double low = INFINITY;
  double high = -INFINITY;
  for (std::size_t i = 0; i < sweep.samples.size(); ++i) {
    s.place_rad.push_back(gear_ratio * sweep.q_rad(i));
    low = std::min(low, s.place_rad.back());
    high = std::max(high, s.place_rad.back());
  }
  // Gravity and a twist turn no sign with the direction.
  const bool is_unlike_gravity = over == Over::angle_by_direction;
  if (is_unlike_gravity || (high - low) / (2 * pi) < fewest_turns) s.search.fewest_periods = 2;
  return s;
}

/// Recordings follow each other: a line has to be coherent within each.
Spectrum over_time(const motion::Sweep& sweep) {
  Spectrum s{Over::time, {}, {}};
  double start = 0;
  double step = INFINITY;
  std::size_t recording = 0;
  for (std::size_t i = 0; i < sweep.samples.size(); ++i) {
    const std::vector<double>& t_s = sweep.recordings[sweep.samples.recording[i]]->t_s;
    if (sweep.samples.recording[i] != recording) {
      const std::vector<double>& before = sweep.recordings[recording]->t_s;
      start += before.back() - before.front();
      recording = sweep.samples.recording[i];
    }
    step = std::min(step, (t_s.back() - t_s.front()) / static_cast<double>(t_s.size() - 1));
    s.place_rad.push_back(2 * pi * (start + t_s[sweep.samples.index[i]] - t_s.front()));
  }
  const double whole_s = (s.place_rad.back() - s.place_rad.front()) / (2 * pi);
  constexpr double most_bins = 60000;
  s.search.bins_per_turn = std::min(1 / step, most_bins / std::max(whole_s, 1e-9));
  s.search.most_periods_per_turn = 0.375 * s.search.bins_per_turn;
  // Friction and load that the model does not know have fewer waves than that over a sweep.
  s.search.fewest_periods = 6;
  return s;
}

/// Standard deviations of what repeats with the angle, even and odd in the direction.
struct AngleRest {
  double even_Nm{}, odd_Nm{};
};

AngleRest angle_rest(const motion::Sweep& sweep, const std::vector<double>& residual) {
  constexpr std::size_t cells = 800;
  constexpr std::size_t blocks = 20;
  double low = INFINITY;
  double high = -INFINITY;
  for (std::size_t i = 0; i < residual.size(); ++i) {
    low = std::min(low, sweep.q_rad(i));
    high = std::max(high, sweep.q_rad(i));
  }
  std::vector<double> sum[2] = {std::vector<double>(cells, 0.0), std::vector<double>(cells, 0.0)};
  std::vector<double> count[2] = {std::vector<double>(cells, 0.0), std::vector<double>(cells, 0.0)};
  for (std::size_t i = 0; i < residual.size(); ++i) {
    const double place = static_cast<double>(cells) * (sweep.q_rad(i) - low) / (high - low);
    const std::size_t cell = std::min(cells - 1, static_cast<std::size_t>(place));
    const int side = sweep.samples.direction[i] > 0 ? 1 : 0;
    sum[side][cell] += residual[i];
    count[side][cell] += 1;
  }
  std::vector<double> mean(blocks, 0.0);
  std::vector<double> used(blocks, 0.0);
  for (std::size_t cell = 0; cell < cells; ++cell) {
    if (count[0][cell] == 0 || count[1][cell] == 0) continue;
    const std::size_t block = cell * blocks / cells;
    mean[block] += sum[0][cell] / count[0][cell] * sum[1][cell] / count[1][cell];
    used[block] += 1;
  }
  double all = 0;
  double n = 0;
  for (std::size_t b = 0; b < blocks; ++b) {
    if (used[b] == 0) continue;
    mean[b] /= used[b];
    all += mean[b];
    n += 1;
  }
  if (n < blocks / 2.0) return {};
  all /= n;
  double squares = 0;
  for (std::size_t b = 0; b < blocks; ++b) squares += used[b] > 0 ? std::pow(mean[b] - all, 2) : 0;
  const double error = std::sqrt(squares / (n - 1) / n);
  constexpr double standard_errors = 2.5;
  if (std::abs(all) < standard_errors * error) return {};
  return all > 0 ? AngleRest{std::sqrt(all), 0} : AngleRest{0, std::sqrt(-all)};
}

}  // namespace

ResidualCauses find_residual_causes(const motion::Sweep& sweep,
                                    const std::vector<double>& residual_Nm, double gear_ratio,
                                    double beyond_white_Nm, double white_variance) {
  const motion::SweepSamples& samples = sweep.samples;
  ResidualCauses out;
  out.lines_Nm.assign(residual_Nm.size(), 0.0);
  const bool both = samples.both_directions();
  std::vector<Spectrum> spectra{over_angle(sweep, gear_ratio, Over::angle)};
  if (both) {
    spectra.push_back(over_angle(sweep, gear_ratio, Over::angle_by_direction));
    spectra.push_back(over_time(sweep));
  }
  std::vector<double> left = residual_Nm;
  const double whole = beyond_white_Nm * beyond_white_Nm;
  double variance = whole;
  const auto sign = [&](const Spectrum& s, std::size_t i) {
    return s.over == Over::angle_by_direction ? samples.direction[i] : 1.0;
  };
  for (std::size_t k = 0; k < most_lines_in_all; ++k) {
    const Spectrum* best = nullptr;
    std::optional<RippleLine> line;
    for (const Spectrum& s : spectra) {
      std::vector<double> seen = left;
      for (std::size_t i = 0; i < seen.size(); ++i) seen[i] *= sign(s, i);
      const auto found = find_strongest_line(s.place_rad, seen, white_variance, s.search);
      const double clearly = s.over == Over::time ? stronger_over_time : 1;
      if (!found || (line && found->amplitude_Nm <= clearly * line->amplitude_Nm)) continue;
      line = found;
      best = &s;
    }
    if (!line) break;
    const double power = line->amplitude_Nm * line->amplitude_Nm / 2;
    if (power < least_line_share * whole) break;
    // Noise that hangs together for long looks like a slow one: it stays in the noise as well.
    const bool is_slow = line->periods_per_turn * best->turns() < RippleSearch{}.fewest_periods;
    for (std::size_t i = 0; i < left.size(); ++i) {
      const double torque = sign(*best, i) * line->amplitude_Nm *
                            std::cos(line->periods_per_turn * best->place_rad[i] + line->phase_rad);
      left[i] -= torque;
      if (!is_slow) out.lines_Nm[i] += torque;
    }
    if (!is_slow) variance -= power;
    if (best->over == Over::angle) out.ripple.lines.push_back(*line);
    if (best->over == Over::angle_by_direction) out.friction.lines.push_back(*line);
    if (best->over == Over::time) {
      out.vibration.push_back({line->periods_per_turn, line->amplitude_Nm});
    }
  }
  for (Ripple* found : {&out.ripple, &out.friction}) {
    std::sort(
        found->lines.begin(), found->lines.end(),
        [](const RippleLine& a, const RippleLine& b) { return a.amplitude_Nm > b.amplitude_Nm; });
  }
  // What the lines leave within the error of the two variances is nothing.
  constexpr double nothing = 0.02;
  variance = variance > nothing * whole ? variance : 0.0;
  if (both) {
    const AngleRest rest = angle_rest(sweep, left);
    out.ripple.rest_Nm = std::min(rest.even_Nm, std::sqrt(variance));
    out.friction.rest_Nm = rest.odd_Nm;
    variance -= std::pow(rest.even_Nm, 2) + std::pow(rest.odd_Nm, 2);
    out.coloured_Nm = std::sqrt(std::max(0.0, variance));
  } else {
    out.ripple.rest_Nm = std::sqrt(variance);
  }
  const auto [low, high] =
      std::minmax_element(spectra.front().place_rad.begin(), spectra.front().place_rad.end());
  if ((*high - *low) / (2 * pi) < fewest_turns && !out.ripple.lines.empty()) {
    // Slower periods look like gravity, and may be as large as those seen.
    out.ripple.rest_Nm = std::hypot(out.ripple.rest_Nm, out.ripple.lines.front().amplitude_Nm);
  }
  return out;
}

}  // namespace tribolog::method::gravity
