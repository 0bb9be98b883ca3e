#include "method/motion/speed_source.h"

#include "statistics/local_slope.h"
#include "statistics/median.h"

namespace tribolog {

std::vector<SpeedSource> speed_sources(const std::vector<Recording>& recordings) {
  std::vector<SpeedSource> sources;
  for (const Recording& r : recordings) {
    if (r.size() < 2) continue;
    const double interval_s = median_interval(r.t_s);
    const std::size_t h = half_window_of_slope(r.size());
    sources.push_back({r.name, r.role, !r.dq_rad_s.empty(), 2 * h,
                       static_cast<double>(2 * h) * interval_s,
                       cut_off_of_slope_Hz(h, interval_s)});
  }
  return sources;
}

}  // namespace tribolog
