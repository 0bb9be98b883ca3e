#include "simulate/drive_noise.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "base/requirements.h"
#include "base/statement.h"
#include "statistics/random_stream.h"

namespace tribolog::simulate {
namespace {

using std::numbers::pi;

void disturb_torque(joint::Recording& recording, const Noise& noise, double gear_ratio,
                    std::uint64_t stream) {
  statistics::RandomStream random(noise.seed, stream);
  for (std::size_t i = 0; i < recording.size(); ++i) {
    double& torque = recording.torque_Nm[i];
    for (const Noise::Ripple& ripple : noise.ripple) {
      const double motor_angle = gear_ratio * recording.q_rad[i];
      torque +=
          ripple.amplitude_Nm * std::sin(ripple.periods_per_turn * motor_angle + ripple.phase_rad);
    }
    if (noise.torque_white_Nm > 0) torque += noise.torque_white_Nm * random.normal();
    if (noise.torque_step_Nm > 0) {
      torque = noise.torque_step_Nm * std::round(torque / noise.torque_step_Nm);
    }
  }
}

void quantise_angle(joint::Recording& recording, const Noise& noise, double gear_ratio) {
  const double step = 2 * pi / noise.encoder_counts_per_turn / gear_ratio;
  const double phase = noise.encoder_phase;
  for (double& q : recording.q_rad) q = step * (std::floor(q / step + phase) - phase);
}

/// The controller's speed: difference of the logged angle through a first-order low pass. It
/// starts from the true speed, as if the controller had been running before.
void filter_speed(joint::Recording& recording, double cut_off_Hz, double sample_rate_Hz) {
  const double keep = std::exp(-2 * pi * cut_off_Hz / sample_rate_Hz);
  double state = recording.dq_rad_s.front();
  for (std::size_t i = 1; i < recording.size(); ++i) {
    const double difference = (recording.q_rad[i] - recording.q_rad[i - 1]) * sample_rate_Hz;
    state = keep * state + (1 - keep) * difference;
    recording.dq_rad_s[i] = state;
  }
}

/// A stream of its own: torque noise is the same on any clock.
statistics::RandomStream clock_stream(const Noise& noise, std::uint64_t stream) {
  constexpr std::uint64_t behind_those_of_torque = std::uint64_t{1} << 32U;
  return {noise.seed, behind_those_of_torque + stream};
}

void disturb_clock(joint::Recording& recording, double jitter_s, double sample_rate_Hz,
                   statistics::RandomStream& random) {
  const double most = 0.45 / sample_rate_Hz;
  for (double& t : recording.t_s) t += std::clamp(jitter_s * random.normal(), -most, most);
}

void lose_samples(joint::Recording& recording, double percent, statistics::RandomStream& random) {
  std::vector<char> is_kept(recording.size());
  for (char& one : is_kept) one = 100 * random.uniform() >= percent ? 1 : 0;
  for (std::vector<double>* signal :
       {&recording.t_s, &recording.q_rad, &recording.dq_rad_s, &recording.torque_Nm,
        &recording.z_rad, &recording.dz_rad_s}) {
    if (signal->empty()) continue;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < is_kept.size(); ++i) {
      if (is_kept[i] != 0) (*signal)[kept++] = (*signal)[i];
    }
    signal->resize(kept);
  }
  recording.rows_read = recording.size();
}

}  // namespace

void add_drive_noise(joint::Recording& recording, const Noise& noise, double gear_ratio,
                     double sample_rate_Hz, std::uint64_t stream) {
  require_not_negative(noise.torque_white_Nm, Code{"parameter.white_torque_noise"}, "N·m");
  require_not_negative(noise.torque_step_Nm, "torque step", "N·m");
  require_not_negative(noise.encoder_counts_per_turn, Code{"parameter.encoder_counts"}, "");
  require_not_negative(noise.speed_filter_Hz, "speed filter", "Hz");
  require_not_negative(noise.clock_jitter_s, "clock jitter", "s");
  require_not_negative(noise.lost_percent, "lost samples", "%");
  if (recording.t_s.empty()) return;
  add_torque_effects(recording, noise.effects, sample_rate_Hz, noise.seed, stream);
  disturb_torque(recording, noise, gear_ratio, stream);
  if (noise.encoder_counts_per_turn > 0) {
    quantise_angle(recording, noise, gear_ratio);
  }
  if (noise.speed_filter_Hz > 0) filter_speed(recording, noise.speed_filter_Hz, sample_rate_Hz);
  add_log_effects(recording, noise.effects, noise.seed, stream);
  statistics::RandomStream clock = clock_stream(noise, stream);
  if (noise.clock_jitter_s > 0) {
    disturb_clock(recording, noise.clock_jitter_s, sample_rate_Hz, clock);
  }
  if (noise.lost_percent > 0) lose_samples(recording, noise.lost_percent, clock);
}

}  // namespace tribolog::simulate
