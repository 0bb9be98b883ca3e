#include "simulate/drive_noise.h"

#include <cmath>
#include <numbers>

#include "parameter_rules.h"

#include "simulate/random_stream.h"

namespace tribolog {
namespace {

using std::numbers::pi;

void disturb_torque(Recording& recording, const Noise& noise, double gear_ratio,
                    std::uint64_t stream) {
  RandomStream random(noise.seed, stream);
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

void quantise_angle(Recording& recording, double counts_per_turn, double gear_ratio) {
  const double step = 2 * pi / counts_per_turn / gear_ratio;
  for (double& q : recording.q_rad) q = step * std::floor(q / step);
}

/// The controller's speed: difference of the logged angle through a first-order low pass. It
/// starts from the true speed, as if the controller had been running before.
void filter_speed(Recording& recording, double cut_off_Hz, double sample_rate_Hz) {
  const double keep = std::exp(-2 * pi * cut_off_Hz / sample_rate_Hz);
  double state = recording.dq_rad_s.front();
  for (std::size_t i = 1; i < recording.size(); ++i) {
    const double difference = (recording.q_rad[i] - recording.q_rad[i - 1]) * sample_rate_Hz;
    state = keep * state + (1 - keep) * difference;
    recording.dq_rad_s[i] = state;
  }
}

}  // namespace

void add_drive_noise(Recording& recording, const Noise& noise, double gear_ratio,
                     double sample_rate_Hz, std::uint64_t stream) {
  require_not_negative(noise.torque_white_Nm, "white torque noise", "N·m");
  require_not_negative(noise.torque_step_Nm, "torque step", "N·m");
  require_not_negative(noise.encoder_counts_per_turn, "encoder counts per turn", "");
  require_not_negative(noise.speed_filter_Hz, "speed filter", "Hz");
  if (recording.t_s.empty()) return;
  disturb_torque(recording, noise, gear_ratio, stream);
  if (noise.encoder_counts_per_turn > 0) {
    quantise_angle(recording, noise.encoder_counts_per_turn, gear_ratio);
  }
  if (noise.speed_filter_Hz > 0) filter_speed(recording, noise.speed_filter_Hz, sample_rate_Hz);
}

}  // namespace tribolog
