#include "method/viscous/paired_sweep.h"

#include <algorithm>
#include <cmath>

#include "method/motion/sweep_samples.h"
#include "statistics/distributions.h"

namespace tribolog::method::viscous {
namespace {

constexpr std::size_t angle_bins = 24;

/// Torque, speed and angle of one direction in one bin, by stroke.
struct Bin {
  std::vector<std::size_t> strokes;
  std::vector<double> torque_sum, count;
  double speed{}, angle{}, cosine{}, sine{}, load{}, samples{};

  void add(std::size_t stroke, double torque, double v, double q, double q_peak) {
    if (strokes.empty() || strokes.back() != stroke) {
      strokes.push_back(stroke);
      torque_sum.push_back(0);
      count.push_back(0);
    }
    torque_sum.back() += torque;
    count.back() += 1;
    speed += v;
    angle += q;
    cosine += std::cos(q - q_peak);
    sine += std::sin(q - q_peak);
    load += std::abs(std::cos(q - q_peak));
    samples += 1;
  }

  /// Mean torque and the 95 % half width from the scatter of the strokes.
  [[nodiscard]] std::pair<double, double> torque() const {
    double mean = 0;
    const auto n = static_cast<double>(strokes.size());
    for (std::size_t k = 0; k < strokes.size(); ++k) mean += torque_sum[k] / count[k] / n;
    double squares = 0;
    for (std::size_t k = 0; k < strokes.size(); ++k) {
      squares += std::pow(torque_sum[k] / count[k] - mean, 2);
    }
    const double half_width =
        n >= 2 ? statistics::student_t_975(n - 1) * std::sqrt(squares / (n - 1) / n) : INFINITY;
    return {mean, half_width};
  }
};

}  // namespace

std::vector<ConstantSpeedRun> pair_sweep_by_angle(const motion::Sweep& sweep,
                                                  const gravity::CogSweepResult& found,
                                                  double gear_ratio, double q_peak_rad) {
  const motion::SweepSamples& samples = sweep.samples;
  std::vector<Bin> up(angle_bins);
  std::vector<Bin> down(angle_bins);
  const double width = (found.highest_rad - found.lowest_rad) / static_cast<double>(angle_bins);
  const double inertia = found.inertia_kgm2 ? found.inertia_kgm2->value * gear_ratio : 0.0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double q = sweep.q_rad(i);
    const auto bin =
        std::min(angle_bins - 1, static_cast<std::size_t>((q - found.lowest_rad) / width));
    const double torque =
        sweep.torque_Nm(i) - found.offset_Nm - inertia * samples.acceleration_rad_s2[i];
    (samples.direction[i] > 0 ? up : down)[bin].add(samples.stroke[i], torque,
                                                    samples.speed_rad_s[i], q, q_peak_rad);
  }
  std::vector<ConstantSpeedRun> runs;
  for (std::size_t bin = 0; bin < angle_bins; ++bin) {
    constexpr double fewest = 10;
    if (up[bin].samples < fewest || down[bin].samples < fewest) continue;
    const auto [torque_up, width_up] = up[bin].torque();
    const auto [torque_down, width_down] = down[bin].torque();
    const double difference = (torque_up - torque_down) / 2;
    const double mean = (torque_up + torque_down) / 2;
    const double half_width = std::hypot(width_up, width_down) / 2;
    const auto index = static_cast<int>(runs.size());
    const auto make = [&](const Bin& b, double torque, double torque_width, int partner,
                          double sign) {
      ConstantSpeedRun run;
      run.recording = sweep.recordings.front()->name;
      run.speed_rad_s = gear_ratio * b.speed / b.samples;
      run.torque_Nm = torque;
      run.torque_half_width_Nm = torque_width;
      run.q_rad = b.angle / b.samples;
      run.mean_cos = b.cosine / b.samples;
      run.mean_sin = b.sine / b.samples;
      run.mean_load = b.load / b.samples;
      run.lowest_rad = found.lowest_rad + static_cast<double>(bin) * width;
      run.highest_rad = run.lowest_rad + width;
      run.samples = static_cast<std::size_t>(b.samples);
      run.partner = partner;
      run.direction_difference_Nm = sign * difference;
      run.direction_difference_half_width_Nm = half_width;
      run.direction_mean_Nm = mean;
      run.direction_mean_cos =
          (up[bin].cosine / up[bin].samples + down[bin].cosine / down[bin].samples) / 2;
      return run;
    };
    runs.push_back(make(down[bin], torque_down, width_down, index + 1, -1));
    runs.push_back(make(up[bin], torque_up, width_up, index, 1));
  }
  return runs;
}

std::vector<ConstantSpeedRun> bin_sweep_by_speed(const motion::Sweep& sweep,
                                                 const gravity::CogSweepResult& found,
                                                 double gear_ratio) {
  constexpr std::size_t most_bins = 14;
  constexpr std::size_t fewest = 20;
  const motion::SweepSamples& samples = sweep.samples;
  std::vector<double> speeds;
  for (const double v : samples.speed_rad_s) speeds.push_back(std::abs(v));
  std::sort(speeds.begin(), speeds.end());
  const std::size_t bins = std::min(most_bins, speeds.size() / (2 * fewest));
  std::vector<ConstantSpeedRun> runs;
  if (bins == 0) return runs;
  std::vector<Bin> up(bins);
  std::vector<Bin> down(bins);
  const double inertia = found.inertia_kgm2 ? found.inertia_kgm2->value * gear_ratio : 0.0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const auto rank =
        std::lower_bound(speeds.begin(), speeds.end(), std::abs(samples.speed_rad_s[i])) -
        speeds.begin();
    const std::size_t bin =
        std::min(bins - 1, static_cast<std::size_t>(rank) * bins / speeds.size());
    const double torque = sweep.torque_Nm(i) - inertia * samples.acceleration_rad_s2[i];
    (samples.direction[i] > 0 ? up : down)[bin].add(samples.stroke[i], torque,
                                                    samples.speed_rad_s[i], sweep.q_rad(i), 0);
  }
  const double slope = found.viscous_Nms_rad ? found.viscous_Nms_rad->value : 0.0;
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t bin = 0; bin < bins; ++bin) {
    if (up[bin].samples < fewest || down[bin].samples < fewest) continue;
    const double rising = up[bin].speed / up[bin].samples;
    const double falling = down[bin].speed / down[bin].samples;
    const double both = gear_ratio * (rising - falling) / 2;
    for (const Bin* one : {&down[bin], &up[bin]}) {
      const auto [torque, half_width] = one->torque();
      ConstantSpeedRun run;
      run.recording = sweep.recordings.front()->name;
      run.speed_rad_s = one == &up[bin] ? both : -both;
      // To the speed that both directions have in common.
      run.torque_Nm = torque + slope * (run.speed_rad_s - gear_ratio * one->speed / one->samples);
      run.torque_half_width_Nm = half_width;
      if (std::isfinite(half_width)) {
        run.torque_standard_error_Nm = half_width / statistics::normal_975;
      }
      run.samples = static_cast<std::size_t>(one->samples);
      run.q_rad = run.lowest_rad = run.highest_rad = nan;
      run.direction_difference_Nm = run.direction_difference_half_width_Nm = nan;
      run.direction_mean_Nm = run.direction_mean_cos = nan;
      runs.push_back(std::move(run));
    }
  }
  return runs;
}

}  // namespace tribolog::method::viscous
