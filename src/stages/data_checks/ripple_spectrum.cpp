#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "stages/data_checks/torque_ripple.h"
#include "stages/median.h"

namespace tribolog {
namespace {

using std::numbers::pi;

constexpr double bins_a_turn = 64;
constexpr double fewest_turns = 5;
constexpr double most_turns = 60;       // of a stroke that are looked at: enough to see a period
constexpr double lowest_period = 0.75;  // periods a turn; slower is gravity's and friction's own
constexpr double highest_period = 20;
constexpr double above_floor = 8;     // a line is so many times the usual amplitude
constexpr double least_share = 1e-4;  // of the torque's range: below, nobody cares
constexpr std::size_t most_lines = 4;

/// Mean torque in equal bins of the motor's angle, from the stroke's start on; bins without samples
/// repeat their neighbour.
std::vector<double> torque_over_angle(const CheckedRecording& r, const Stroke& stroke,
                                      double gear_ratio) {
  const double turns = std::min(most_turns, gear_ratio * stroke.travel_rad / (2 * pi));
  const double travel_rad = 2 * pi * turns / gear_ratio;
  const auto count = static_cast<std::size_t>(turns * bins_a_turn);
  std::vector<double> sum(count, 0.0);
  std::vector<std::size_t> samples(count, 0);
  const double start = r.recording->q_rad[stroke.first];
  for (std::size_t i = stroke.first; i < stroke.last; ++i) {
    const double place = stroke.direction * (r.recording->q_rad[i] - start) / travel_rad;
    if (!(place >= 0 && place < 1)) continue;
    const auto k = static_cast<std::size_t>(place * static_cast<double>(count));
    sum[k] += r.recording->torque_Nm[i];
    ++samples[k];
  }
  for (std::size_t k = 0; k < count; ++k) {
    if (samples[k] > 0) {
      sum[k] /= static_cast<double>(samples[k]);
    } else {
      sum[k] = k > 0 ? sum[k - 1] : r.recording->torque_Nm[stroke.first];
    }
  }
  return sum;
}

/// Less the mean over two turns about each place; the ends, which have none, are cut off.
std::vector<double> less_slow_part(const std::vector<double>& y) {
  const auto half = static_cast<std::size_t>(bins_a_turn);
  std::vector<double> fast;
  double sum = 0;
  for (std::size_t k = 0; k < 2 * half && k < y.size(); ++k) sum += y[k];
  for (std::size_t k = half; k + half < y.size(); ++k) {
    fast.push_back(y[k] - sum / static_cast<double>(2 * half));
    sum += y[k + half] - y[k - half];
  }
  return fast;
}

/// Amplitude of a sine of this many periods a turn, under a Hann window.
double amplitude_at(const std::vector<double>& y, double periods_per_turn) {
  const auto n = static_cast<double>(y.size());
  const std::complex<double> turn = std::polar(1.0, 2 * pi * periods_per_turn / bins_a_turn);
  std::complex<double> phase = 1;
  std::complex<double> sum = 0;
  for (std::size_t k = 0; k < y.size(); ++k) {
    const double window = 1 - std::cos(2 * pi * (static_cast<double>(k) + 0.5) / n);
    sum += window * y[k] * phase;
    phase *= turn;
  }
  return 2 * std::abs(sum) / n;
}

}  // namespace

TorqueRipple find_torque_ripple(const CheckedDataset& data) {
  TorqueRipple out;
  const double n = data.manifest->drive.gear_ratio();
  std::vector<std::vector<double>> strokes;
  double low = 0, high = 0;
  for (const CheckedRecording* r : data.with_role(Role::rough_sweep)) {
    for (const Stroke& stroke : r->strokes) {
      const double turns = std::min(most_turns, n * stroke.travel_rad / (2 * pi));
      if (turns < fewest_turns) continue;
      const std::vector<double> torque = torque_over_angle(*r, stroke, n);
      const auto [least, most] = std::minmax_element(torque.begin(), torque.end());
      low = strokes.empty() ? *least : std::min(low, *least);
      high = strokes.empty() ? *most : std::max(high, *most);
      strokes.push_back(less_slow_part(torque));
      out.motor_turns = std::max(out.motor_turns, turns - 2);
    }
  }
  if (strokes.empty()) return out;
  out.torque_range_Nm = high - low;

  const double step = 1 / (4 * out.motor_turns);
  std::vector<double> amplitudes;
  for (double periods = lowest_period; periods < highest_period; periods += step) {
    double squares = 0;
    for (const auto& stroke : strokes) squares += std::pow(amplitude_at(stroke, periods), 2);
    amplitudes.push_back(std::sqrt(squares / static_cast<double>(strokes.size())));
  }
  const double floor =
      std::max(above_floor * median(amplitudes), least_share * out.torque_range_Nm);
  for (std::size_t k = 1; k + 1 < amplitudes.size(); ++k) {
    if (amplitudes[k] < floor || amplitudes[k] < amplitudes[k - 1] ||
        amplitudes[k] < amplitudes[k + 1]) {
      continue;
    }
    // The top of the parabola through three neighbours.
    const double left = amplitudes[k - 1], right = amplitudes[k + 1];
    const double bend = left - 2 * amplitudes[k] + right;
    const double shift = bend < 0 ? (left - right) / bend / 2 : 0.0;
    out.lines.push_back({lowest_period + (static_cast<double>(k) + shift) * step, amplitudes[k]});
  }
  std::sort(out.lines.begin(), out.lines.end(), [](const RippleLine& a, const RippleLine& b) {
    return a.amplitude_Nm > b.amplitude_Nm;
  });
  // What is left of a strong line beside it, through the window, is no line of its own.
  constexpr double side_lobe = 0.05;
  while (!out.lines.empty() &&
         (out.lines.size() > most_lines ||
          out.lines.back().amplitude_Nm < side_lobe * out.lines.front().amplitude_Nm)) {
    out.lines.pop_back();
  }
  return out;
}

}  // namespace tribolog
