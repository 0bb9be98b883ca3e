#include "calibration/friction_speeds.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace tribolog::calibration {

FrictionAtSpeed at_joint(FrictionAtSpeed at_motor, double gear_ratio) {
  const double n = std::abs(gear_ratio);
  at_motor.speed_rad_s /= n;
  at_motor.torque_Nm = statistics::scaled(at_motor.torque_Nm, n);
  return at_motor;
}

std::vector<std::size_t> evenly_in_log(const std::vector<double>& speeds_rad_s, std::size_t count) {
  std::vector<std::size_t> chosen;
  if (speeds_rad_s.empty() || count == 0) return chosen;
  const double first = std::log(speeds_rad_s.front());
  const double range = std::log(speeds_rad_s.back()) - first;
  const double steps = static_cast<double>(std::max<std::size_t>(count - 1, 1));
  for (std::size_t k = 0; k < count; ++k) {
    const double sought = first + range * static_cast<double>(k) / steps;
    const auto nearest =
        std::min_element(speeds_rad_s.begin(), speeds_rad_s.end(), [&](double a, double b) {
          return std::abs(std::log(a) - sought) < std::abs(std::log(b) - sought);
        });
    const auto at = static_cast<std::size_t>(nearest - speeds_rad_s.begin());
    if (chosen.empty() || at > chosen.back()) chosen.push_back(at);
  }
  return chosen;
}

std::vector<FrictionAtSpeed> evenly_in_log(const std::vector<FrictionAtSpeed>& all,
                                           std::size_t count) {
  std::vector<double> speeds_rad_s;
  for (const FrictionAtSpeed& f : all) speeds_rad_s.push_back(f.speed_rad_s);
  std::vector<FrictionAtSpeed> chosen;
  for (const std::size_t k : evenly_in_log(speeds_rad_s, count)) chosen.push_back(all[k]);
  return chosen;
}

std::vector<SpeedRange> usable_ranges(const std::vector<FrictionAtSpeed>& all, std::size_t most) {
  struct Stretch {
    std::ptrdiff_t from{};
    std::ptrdiff_t end{};
  };
  const auto is_usable = [](const FrictionAtSpeed& f) { return f.verdict == Verdict::usable; };
  std::vector<Stretch> stretches;
  for (auto from = std::find_if(all.begin(), all.end(), is_usable); from != all.end();) {
    const auto end = std::find_if_not(from, all.end(), is_usable);
    stretches.push_back({from - all.begin(), end - all.begin()});
    from = std::find_if(end, all.end(), is_usable);
  }
  std::stable_sort(stretches.begin(), stretches.end(), [](const Stretch& a, const Stretch& b) {
    return a.end - a.from > b.end - b.from;
  });
  stretches.resize(std::min(stretches.size(), most));
  std::sort(stretches.begin(), stretches.end(),
            [](const Stretch& a, const Stretch& b) { return a.from < b.from; });
  std::vector<SpeedRange> ranges;
  for (const Stretch& one : stretches) {
    ranges.push_back({all[static_cast<std::size_t>(one.from)].speed_rad_s,
                      all[static_cast<std::size_t>(one.end - 1)].speed_rad_s});
  }
  return ranges;
}

}  // namespace tribolog::calibration
