#include "method/session/oscillation_levels.h"

#include <algorithm>
#include <cmath>

#include "method/motion/oscillation_motion.h"

namespace tribolog::method::session {
namespace {

constexpr double alike = 0.02;          // amplitude, frequency
constexpr double same_place_rad = 0.1;  // over which load and angle change friction little
constexpr std::size_t fewest_cycles = 4;

struct CycleWork {
  double share{};        // of the session, at the middle of the cycle
  double friction_Nm{};  // work over twice the travel
};

std::vector<CycleWork> works_of(std::size_t recording, const joint::Recording& r,
                                const motion::OscillationMotion& motion,
                                const SessionTimes& times) {
  const simulate::HarmonicMotion angle = motion.motor_motion(1);
  const double period = 1 / motion.frequency_Hz;
  const auto whole = static_cast<std::size_t>((r.t_s.back() - r.t_s.front()) / period + 1e-6);
  std::vector<CycleWork> works;
  // The first cycle starts from rest.
  std::size_t i = 0;
  for (std::size_t k = 1; k < whole; ++k) {
    const double from = r.t_s.front() + static_cast<double>(k) * period;
    while (i < r.size() && r.t_s[i] < from) ++i;
    double work = 0;
    double n = 0;
    double low = r.q_rad[std::min(i, r.size() - 1)];
    double high = low;
    for (; i < r.size() && r.t_s[i] < from + period; ++i) {
      const double speed = angle.speed(r.t_s[i] - motion.start_s);
      work += r.torque_Nm[i] * speed;
      n += 1;
      low = std::min(low, r.q_rad[i]);
      high = std::max(high, r.q_rad[i]);
    }
    if (n < 8) continue;
    works.push_back({times.share(recording, r, from + period / 2),
                     work / n * period / (4 * motion.amplitude_rad)});
  }
  return works;
}

FrictionLevel mean_of(const std::vector<CycleWork>& works, std::size_t first, std::size_t last,
                      double scatter, int family) {
  FrictionLevel level;
  level.family = family;
  const auto n = static_cast<double>(last - first);
  for (std::size_t k = first; k < last; ++k) {
    level.friction_Nm += works[k].friction_Nm / n;
    level.session_share.push_back(works[k].share);
  }
  level.standard_error_Nm = scatter / std::sqrt(n);
  return level;
}

/// Scatter from cycle to cycle, without slow changes.
double scatter_of(const std::vector<CycleWork>& works) {
  double squares = 0;
  for (std::size_t k = 1; k < works.size(); ++k) {
    squares += std::pow(works[k].friction_Nm - works[k - 1].friction_Nm, 2);
  }
  return std::sqrt(squares / 2 / static_cast<double>(works.size() - 1));
}

}  // namespace

std::vector<FrictionLevel> oscillation_levels(const std::vector<joint::Recording>& recordings,
                                              const SessionTimes& times) {
  std::vector<motion::OscillationMotion> families;
  std::vector<FrictionLevel> levels;
  for (std::size_t i = 0; i < recordings.size(); ++i) {
    const joint::Recording& r = recordings[i];
    if (r.role != joint::Role::oscillation || r.torque_Nm.empty()) continue;
    const std::optional<motion::OscillationMotion> motion = motion::fit_oscillation_motion(r);
    if (!motion || motion->residual_rad > 0.05 * motion->amplitude_rad) continue;
    const std::vector<CycleWork> works = works_of(i, r, *motion, times);
    if (works.size() < fewest_cycles) continue;
    const auto same = std::find_if(families.begin(), families.end(), [&](const auto& f) {
      return std::abs(f.amplitude_rad / motion->amplitude_rad - 1) < alike &&
             std::abs(f.frequency_Hz / motion->frequency_Hz - 1) < alike &&
             std::abs(f.centre_rad - motion->centre_rad) < same_place_rad;
    });
    const auto family = static_cast<int>(same - families.begin());
    if (same == families.end()) families.push_back(*motion);
    const double scatter = scatter_of(works);
    const std::size_t middle = works.size() / 2;
    levels.push_back(mean_of(works, 0, middle, scatter, family));
    levels.push_back(mean_of(works, middle, works.size(), scatter, family));
  }
  return levels;
}

}  // namespace tribolog::method::session
