#include "method/motion/sweep_samples.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "statistics/order_statistics.h"

namespace tribolog::method::motion {
namespace {

// Below this share of the fastest speed a varying sweep is close to a reversal, where friction is
// in transition.
constexpr double slowest_share = 0.1;
// From this share of moving samples on plateaus a sweep counts as one of constant speed. A sine is
// within 2 % of its fastest speed over 20 % of its travel.
constexpr double plateau_share_of_constant_speed = 0.5;
// Beyond this multiple of the acceleration that nine tenths of the moving samples stay below, a
// varying sweep is stopped or started abruptly, which no term of the fit describes.
constexpr double abrupt_multiple = 3.0;
constexpr double usual_share = 0.9;

bool is_slow(const MotionSegments& motion, std::size_t i) {
  return std::abs(motion.speed_rad_s[i]) <= slowest_share * motion.fastest_rad_s ||
         motion.fastest_rad_s == 0;
}

/// Samples at an abrupt stop or start, and those within two windows of it: the local slopes there
/// are computed from some of its samples, and structure and controller settle.
std::vector<bool> abrupt_samples(const MotionSegments& motion) {
  const std::size_t n = motion.speed_rad_s.size();
  std::vector<bool> abrupt(n, false);
  std::vector<double> sizes;
  for (std::size_t i = 0; i < n; ++i) {
    if (!is_slow(motion, i)) sizes.push_back(std::abs(motion.acceleration_rad_s2[i]));
  }
  if (sizes.empty()) return abrupt;
  const double limit = abrupt_multiple * statistics::value_at_share(std::move(sizes), usual_share);
  if (!(limit > 0)) return abrupt;
  const std::size_t margin = 2 * motion.window;
  for (std::size_t i = 0; i < n; ++i) {
    if (is_slow(motion, i) || std::abs(motion.acceleration_rad_s2[i]) <= limit) continue;
    const auto from = abrupt.begin() + static_cast<std::ptrdiff_t>(i - std::min(i, margin));
    const auto to = abrupt.begin() + static_cast<std::ptrdiff_t>(std::min(n, i + margin + 1));
    std::fill(from, to, true);
  }
  return abrupt;
}

}  // namespace

bool SweepSamples::both_directions() const {
  const bool up = std::any_of(direction.begin(), direction.end(), [](double d) { return d > 0; });
  const bool down = std::any_of(direction.begin(), direction.end(), [](double d) { return d < 0; });
  return up && down;
}

SweepSamples select_sweep_samples(const std::vector<const joint::Recording*>& recordings) {
  SweepSamples out;
  std::vector<MotionSegments> motions;
  double on_plateaus = 0;
  double all = 0;
  for (const joint::Recording* recording : recordings) {
    motions.push_back(find_plateaus(*recording));
    on_plateaus += motions.back().plateau_share() * static_cast<double>(recording->size());
    all += static_cast<double>(recording->size());
  }
  out.constant_speed = all > 0 && on_plateaus >= plateau_share_of_constant_speed * all;

  std::size_t stroke = 0;
  const auto take = [&](std::size_t r, std::size_t i, double direction) {
    out.recording.push_back(r);
    out.index.push_back(i);
    out.stroke.push_back(stroke);
    out.direction.push_back(direction);
    out.speed_rad_s.push_back(motions[r].speed_rad_s[i]);
    out.acceleration_rad_s2.push_back(motions[r].acceleration_rad_s2[i]);
  };
  for (std::size_t r = 0; r < recordings.size(); ++r) {
    const MotionSegments& motion = motions[r];
    if (out.constant_speed) {
      for (const Plateau& plateau : motion.plateaus) {
        const double direction = plateau.speed_rad_s > 0 ? 1.0 : -1.0;
        for (std::size_t i = plateau.first; i < plateau.last; ++i) take(r, i, direction);
        ++stroke;
      }
      continue;
    }
    const std::vector<bool> abrupt = abrupt_samples(motion);
    double last_direction = 0;
    for (std::size_t i = 0; i < recordings[r]->size(); ++i) {
      const double v = motion.speed_rad_s[i];
      if (is_slow(motion, i) || abrupt[i]) continue;
      const double direction = v > 0 ? 1.0 : -1.0;
      if (last_direction != 0 && direction != last_direction) ++stroke;
      last_direction = direction;
      take(r, i, direction);
    }
    ++stroke;
  }
  std::size_t total = 0;
  for (const joint::Recording* recording : recordings) total += recording->size();
  out.left_out = total - out.size();
  return out;
}

Sweep::Sweep(std::vector<const joint::Recording*> of_sweep)
    : recordings(std::move(of_sweep)), samples(select_sweep_samples(recordings)) {}

std::vector<std::vector<bool>> Sweep::used() const {
  std::vector<std::vector<bool>> masks;
  for (const joint::Recording* recording : recordings) masks.emplace_back(recording->size(), false);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    masks[samples.recording[i]][samples.index[i]] = true;
  }
  return masks;
}

}  // namespace tribolog::method::motion
