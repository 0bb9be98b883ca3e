#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "statistics/random_stream.h"
#include "statistics/sampled_signal.h"
#include "truth/identified_joint.h"

namespace tribolog::truth {
namespace {

/// What the fit leaves of each sample, against the motor's angle.
struct Leftover {
  std::vector<double> motor_rad;
  std::vector<double> torque_Nm;
};

/// Torque less the fitted curve of its direction, the curve being tabled over the angle.
Leftover leftover_of(const std::vector<const joint::Recording*>& recordings,
                     const method::gravity::SweepCurves& rough, double gear_ratio) {
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
  for (std::size_t k = 0; k < std::min(recordings.size(), rough.used.size()); ++k) {
    const joint::Recording& r = *recordings[k];
    constexpr std::size_t reach = 5;  // over which the direction is seen through encoder steps
    for (std::size_t i = reach; i + reach < r.size(); ++i) {
      if (!rough.used[k][i]) continue;
      const bool rising = r.q_rad[i + reach] > r.q_rad[i - reach];
      const double rest =
          r.torque_Nm[i] - fitted(rising ? rough.fit_rising_Nm : rough.fit_falling_Nm, r.q_rad[i]);
      if (!std::isfinite(rest)) continue;
      out.motor_rad.push_back(gear_ratio * r.q_rad[i]);
      out.torque_Nm.push_back(rest);
    }
  }
  return out;
}

/// As fine as the samples allow: behind a gear that is part of the joint, as a joint's torque has
/// it, the motor turns a hundred times in what is called one turn here.
method::gravity::RippleSearch finest_search(const method::gravity::CogSweepResult& rough,
                                            double gear_ratio) {
  constexpr std::size_t samples_in_bin = 8;
  constexpr std::size_t most_bins = 4096;  // over the sweep; they bound the work
  constexpr double bins_in_period = 8;
  constexpr double most_periods_per_turn = 400;
  const double turns = gear_ratio * (rough.highest_rad - rough.lowest_rad) / (2 * std::numbers::pi);
  const std::size_t bins = std::min(most_bins, rough.samples_used / samples_in_bin);
  const double per_turn = static_cast<double>(bins) / turns;
  return {per_turn, std::min(most_periods_per_turn, per_turn / bins_in_period)};
}

}  // namespace

double white_torque_Nm(const std::vector<double>& torque_Nm) {
  std::vector<double> third = statistics::third_differences(torque_Nm);
  const double root_mean_square = std::sqrt(statistics::white_variance(third));
  return std::min(root_mean_square, statistics::white_sd_beside_jumps(std::move(third)));
}

std::vector<simulate::Noise::Ripple> ripple_of(const joint::Dataset& dataset,
                                               const method::gravity::CogSweepResult& rough,
                                               const method::gravity::SweepCurves& curves) {
  constexpr std::size_t most_periods = 4;
  constexpr double least_share = 0.1;  // of the ripple's variance, for a period to be put in
  if (!rough.found || !(rough.ripple_Nm > 0) || !(rough.highest_rad > rough.lowest_rad)) return {};
  const double gear_ratio = dataset.manifest.drive.gear_ratio();
  const Leftover rest =
      leftover_of(dataset.with_role(joint::Role::rough_sweep), curves, gear_ratio);
  const double wanted = rough.ripple_Nm * rough.ripple_Nm;
  const double white_variance = rough.residual_Nm * rough.residual_Nm - wanted;
  const method::gravity::Ripple found =
      method::gravity::find_ripple(rest.motor_rad, rest.torque_Nm, rough.ripple_Nm, white_variance,
                                   finest_search(rough, gear_ratio));
  std::vector<simulate::Noise::Ripple> kept;
  double variance = 0;
  for (const method::gravity::RippleLine& line : found.lines) {
    const double of_line = line.amplitude_Nm * line.amplitude_Nm / 2;
    if (kept.size() == most_periods || of_line < least_share * wanted) break;
    // The spectrum's lines are cosines, the drive's ripple is made of sines.
    kept.push_back(
        {line.amplitude_Nm, line.periods_per_turn, line.phase_rad + std::numbers::pi / 2});
    variance += of_line;
  }
  for (simulate::Noise::Ripple& one : kept) one.amplitude_Nm *= std::sqrt(wanted / variance);
  return kept;
}

joint::Dataset with_noise(const IdentifiedJoint& joint, std::uint64_t seed, std::size_t run) {
  constexpr std::uint64_t first_recording_stream = 1ULL << 32;
  joint::Dataset dataset = joint.dataset;
  statistics::RandomStream phases(seed, run);
  std::vector<simulate::Noise::Ripple> ripple = joint.ripple;
  for (simulate::Noise::Ripple& one : ripple)
    one.phase_rad = 2 * std::numbers::pi * phases.uniform();
  const double n = dataset.manifest.drive.gear_ratio();
  for (std::size_t k = 0; k < dataset.recordings.size(); ++k) {
    joint::Recording& r = dataset.recordings[k];
    // Streams of the recordings lie beyond those of the phases, each of its own.
    statistics::RandomStream random(seed,
                                    first_recording_stream + run * dataset.recordings.size() + k);
    const double step = joint.torque_step_Nm[k];
    for (std::size_t i = 0; i < r.size(); ++i) {
      double& torque = r.torque_Nm[i];
      for (const simulate::Noise::Ripple& one : ripple) {
        torque +=
            one.amplitude_Nm * std::sin(one.periods_per_turn * n * r.q_rad[i] + one.phase_rad);
      }
      if (joint.white_Nm[k] > 0) torque += joint.white_Nm[k] * random.normal();
      if (step > 0) torque = step * std::round(torque / step);
    }
  }
  constexpr std::uint64_t first_stream_of_points = 1ULL << 48;
  for (std::size_t k = 0; k < dataset.friction_points.size(); ++k) {
    statistics::RandomStream random(
        seed, first_stream_of_points + run * dataset.friction_points.size() + k);
    for (double& torque : dataset.friction_points[k].torque_Nm) {
      torque += joint.scatter_of_points_Nm[k] * random.normal();
    }
  }
  return dataset;
}

}  // namespace tribolog::truth
