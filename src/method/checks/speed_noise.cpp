// How much of the logged speed is noise: a two-point difference of a stepped angle is nothing else
// at low speed.

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "method/checks/check_list.h"
#include "statistics/median.h"
#include "statistics/white_noise.h"

namespace tribolog {
namespace {

/// Scatter of the logged speed about the slope of the angle, in % of the usual speed; < 0: unknown.
double noise_percent(const CheckedRecording& r) {
  const Recording& log = *r.recording;
  if (log.dq_rad_s.empty() || r.strokes.empty() || r.motion.fastest_rad_s <= 0) return -1;
  constexpr double rest_share = 0.1;
  std::vector<double> speeds;
  std::vector<double> deviations;
  for (std::size_t i = 0; i < log.size(); ++i) {
    const double slope = r.motion.speed_rad_s[i];
    if (std::abs(slope) < rest_share * r.motion.fastest_rad_s) continue;
    speeds.push_back(std::abs(slope));
    deviations.push_back(std::abs(log.dq_rad_s[i] - slope));
  }
  if (speeds.size() < 20) return -1;
  return 100 * normal_sd_by_median_size * median(std::move(deviations)) / median(std::move(speeds));
}

}  // namespace

DataCheck check_speed_noise(const CheckedDataset& data) {
  constexpr double most_percent = 50;
  DataCheck check;
  check.name = "speed_noise";
  check.title = "Noise of the logged speed";
  check.measure = "scatter of the logged speed about the angle's slope, of the speed";
  check.unit = percent_sign;
  check.at_most = most_percent;
  for (const CheckedRecording& r : data.recordings) {
    if (!r.travels()) continue;  // no stage reads a speed off a loop or a ramp
    const double noise = noise_percent(r);
    if (noise >= 0) take_if_worst(check, noise, r.recording->name);
  }
  if (!check.measured) {
    return not_applicable(check.name, check.title, "no speed is logged in a sweep or a run");
  }
  check.found = fmt::format("the logged speed scatters by {:.3g} % of the speed", *check.measured);
  check.state = *check.measured <= most_percent ? CheckState::passed : CheckState::warns;
  if (check.state == CheckState::passed) return check;
  check.found += "; at this speed it is hardly more than the steps of the angle";
  check.consequence = "none for the results: speeds are taken from the angle";
  check.experiment = "do not use this column at low speed; differentiate the angle";
  return check;
}

}  // namespace tribolog
