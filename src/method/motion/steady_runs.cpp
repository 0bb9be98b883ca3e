#include "method/motion/steady_runs.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "method/motion/encoder_resolution.h"
#include "method/motion/plateaus.h"
#include "statistics/sampled_signal.h"

namespace tribolog::method::motion {
namespace {

/// One per sample of the plateau. The windows reach into what was cut off its ends as settling, and
/// no farther: not to samples that could be the ramp's.
/// @param half_window of the slopes by which the plateau was found.
std::vector<double> accelerations(const joint::Recording& r, const Plateau& plateau,
                                  std::size_t half_window) {
  const std::size_t settling = std::max(2 * half_window, plateau.size() / 18);
  const std::size_t h = std::max(half_window, settling - 2 * half_window) / 2;
  const std::size_t first = plateau.first - std::min(plateau.first, 2 * h);
  const std::size_t last = std::min(r.size(), plateau.last + 2 * h);
  const auto part = [&](const std::vector<double>& signal) {
    return std::vector<double>(signal.begin() + static_cast<std::ptrdiff_t>(first),
                               signal.begin() + static_cast<std::ptrdiff_t>(last));
  };
  const std::vector<double> t = part(r.t_s);
  const std::vector<double> all = statistics::local_curvature(t, part(r.q_rad), h);
  const auto from = all.begin() + static_cast<std::ptrdiff_t>(plateau.first - first);
  return {from, from + static_cast<std::ptrdiff_t>(plateau.size())};
}

}  // namespace

SteadyRuns::SteadyRuns(std::vector<const joint::Recording*> recordings, double inertia_kgm2)
    : logged_(std::move(recordings)) {
  for (const joint::Recording* r : logged_) {
    torque_step_Nm_ = std::max(torque_step_Nm_, common_step(r->torque_Nm));
  }
  if (!(inertia_kgm2 > 0)) return;
  without_inertia_.reserve(logged_.size());
  for (const joint::Recording* r : logged_) {
    joint::Recording& steady = without_inertia_.emplace_back(*r);
    std::vector<double>& taken_off_Nm = taken_off_Nm_.emplace_back(r->size(), 0.0);
    const MotionSegments motion = find_plateaus(*r);
    for (const Plateau& plateau : motion.plateaus) {
      const std::vector<double> acceleration = accelerations(*r, plateau, motion.window / 2);
      for (std::size_t k = 0; k < plateau.size(); ++k) {
        const std::size_t i = plateau.first + k;
        taken_off_Nm[i] = inertia_kgm2 * acceleration[k];
        steady.torque_Nm[i] -= taken_off_Nm[i];
      }
    }
  }
}

const std::vector<double>& SteadyRuns::taken_off_Nm(std::size_t recording) const {
  static const std::vector<double> nothing;
  return taken_off_Nm_.empty() ? nothing : taken_off_Nm_[recording];
}

std::vector<const joint::Recording*> SteadyRuns::recordings() const {
  if (without_inertia_.empty()) return logged_;
  std::vector<const joint::Recording*> all;
  for (const joint::Recording& r : without_inertia_) all.push_back(&r);
  return all;
}

}  // namespace tribolog::method::motion
