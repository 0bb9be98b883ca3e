#include "method/motion/followed_motion.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <utility>
#include <vector>

namespace tribolog::method::motion {
namespace {

using Harmonics = std::vector<simulate::HarmonicMotion::Harmonic>;

/// Harmonics that count time from later, counted from `earlier_s` before.
void count_from(double earlier_s, double frequency_Hz, Harmonics& harmonics) {
  for (std::size_t k = 0; k < harmonics.size(); ++k) {
    const auto order = static_cast<double>(k + 1);
    // c cos x + s sin x is the real part of (c - i s) exp(i x).
    const std::complex<double> turned =
        std::complex<double>(harmonics[k].cosine, -harmonics[k].sine) *
        std::polar(1.0, -2 * std::numbers::pi * order * frequency_Hz * earlier_s);
    harmonics[k] = {turned.real(), -turned.imag()};
  }
}

/// Harmonics of what comes `from_s` after the first sample, as a motion from the first sample on.
std::optional<OscillationMotion> later_motion(const joint::Recording& r, double from_s) {
  const auto first = std::lower_bound(r.t_s.begin(), r.t_s.end(), r.t_s.front() + from_s);
  const auto skipped = first - r.t_s.begin();
  joint::Recording later;
  later.t_s.assign(first, r.t_s.end());
  later.q_rad.assign(r.q_rad.begin() + skipped, r.q_rad.end());
  later.torque_Nm.assign(r.torque_Nm.begin() + skipped, r.torque_Nm.end());
  std::optional<OscillationMotion> motion = fit_oscillation_motion(later);
  if (!motion) return motion;
  const double earlier_s = motion->start_s - r.t_s.front();
  count_from(earlier_s, motion->frequency_Hz, motion->harmonics);
  for (Harmonics& series : motion->of_torque) {
    count_from(earlier_s, motion->frequency_Hz, series);
  }
  motion->start_s = r.t_s.front();
  return motion;
}

/// Whether what the harmonics leave is the angle's noise, and a little of what that makes of them;
/// noise that does not hide what is no harmonic.
bool leaves_noise(const OscillationMotion& motion, double noise_rad, double encoder_step_rad) {
  constexpr double largest_share_of_noise = 2;
  constexpr double least_share_of_amplitude = 1e-5;  // no bristle sees less
  constexpr double largest_share_of_amplitude = 0.02;
  return motion.residual_rad <= std::max(largest_share_of_noise * noise_rad,
                                         least_share_of_amplitude * motion.amplitude_rad) &&
         motion.residual_rad <=
             std::max(largest_share_of_amplitude * motion.amplitude_rad, encoder_step_rad);
}

}  // namespace

FollowedMotion follow_the_angle(const joint::Recording& r, double encoder_step_rad) {
  constexpr int most_cycles_skipped = 2;
  constexpr double fewest_cycles_left = 3;
  FollowedMotion out;
  out.harmonic = fit_oscillation_motion(r);
  const double noise = noise_of_angle(r.q_rad, encoder_step_rad);
  if (out.harmonic && leaves_noise(*out.harmonic, noise, encoder_step_rad)) {
    out.is_followed = true;
    return out;
  }
  double weighed_from_s = 0;
  if (out.harmonic) {
    const double period = 1 / out.harmonic->frequency_Hz;
    const double cycles = (r.t_s.back() - r.t_s.front()) / period;
    if (cycles >= 1 + fewest_cycles_left) weighed_from_s = period;
    for (int k = 1; k <= most_cycles_skipped && cycles >= k + fewest_cycles_left; ++k) {
      std::optional<OscillationMotion> later = later_motion(r, k * period);
      if (!later || !leaves_noise(*later, noise, encoder_step_rad)) continue;
      out.harmonic = std::move(later);
      out.from_s = k * period;
      out.is_followed = true;
      return out;
    }
  }
  MotionTrace trace = trace_motion(r, nullptr, weighed_from_s);
  out.traced = std::move(trace.motion);
  out.why_not_traced = std::move(trace.refusal);
  out.is_followed = out.traced || (out.harmonic && out.harmonic->is_near_sine(encoder_step_rad));
  return out;
}

}  // namespace tribolog::method::motion
