// Does the logged speed agree with the derivative of the angle?
//
// Both are compared as increments over windows: the integral of the logged speed and the difference
// of the angle. Steps of the encoder and the noise of a two-point difference cancel within a
// window.

#include <algorithm>
#include <cmath>
#include <optional>

#include "method/checks/check_list.h"
#include "method/checks/scale_causes.h"
#include "statistics/distributions.h"
#include "statistics/order_statistics.h"
#include "statistics/sampled_signal.h"

namespace tribolog::method::checks {

namespace {

constexpr std::size_t windows = 50;
constexpr std::size_t fewest_samples_a_window = 4;
constexpr double tolerated = 0.02;  // filters and clocks of real drives stay within
constexpr double certainly_wrong = 0.05;

struct SpeedScale {
  double factor{};
  double half_width{};
  double correlation{};
  double range_rad{};
};

std::optional<SpeedScale> speed_scale(const CheckedRecording& r) {
  const joint::Recording& log = *r.recording;
  if (log.dq_rad_s.empty() || r.strokes.empty()) return std::nullopt;
  if (log.role == joint::Role::break_away) return std::nullopt;  // hardly a motion to compare
  const std::size_t width = std::max(fewest_samples_a_window, log.size() / windows);
  double xx = 0, xy = 0, yy = 0, count = 0;
  for (std::size_t first = 0; first + width < log.size(); first += width) {
    double integral = 0;
    for (std::size_t i = first; i < first + width; ++i) {
      integral += (log.dq_rad_s[i] + log.dq_rad_s[i + 1]) / 2 * (log.t_s[i + 1] - log.t_s[i]);
    }
    const double increment = log.q_rad[first + width] - log.q_rad[first];
    xx += integral * integral;
    xy += integral * increment;
    yy += increment * increment;
    count += 1;
  }
  if (count < 5 || !(yy > 0)) return std::nullopt;
  SpeedScale scale;
  scale.factor = xy / yy;
  scale.half_width = statistics::student_t_975(count - 1) *
                     std::sqrt(std::max(0.0, xx - xy * xy / yy) / (count - 1) / yy);
  scale.correlation = xx > 0 ? std::abs(xy) / std::sqrt(xx * yy) : 0.0;
  scale.range_rad = r.range_rad();
  return scale;
}

/// How far the factor is from 1, beyond its own uncertainty.
double excess(const SpeedScale& s) { return std::max(0.0, std::abs(s.factor - 1) - s.half_width); }

}  // namespace

DataCheck check_speed_scale(const CheckedDataset& data) {
  DataCheck check;
  check.name = CheckName::speed_scale;
  check.measure = {"measure.speed_of_derivative"};
  check.unit = pure_number;
  check.at_least = 1 - tolerated;
  check.at_most = 1 + tolerated;
  std::optional<SpeedScale> worst;
  std::size_t all = 0;
  std::size_t wrong = 0;
  for (const CheckedRecording& r : data.recordings) {
    const auto scale = speed_scale(r);
    if (!scale) continue;
    ++all;
    if (excess(*scale) > tolerated) ++wrong;
    if (worst && excess(*scale) <= excess(*worst)) continue;
    worst = scale;
    check.recording = r.recording->name;
  }
  if (!worst) {
    return not_applicable(check.name, {"not_applicable.no_speed_beside_angle"});
  }
  check.measured = worst->factor;
  const StatedValue factor{"factor", worst->factor};
  const StatedValue half_width{"half_width", worst->half_width};
  if (wrong == 0) {
    check.state = CheckState::passed;
    check.found = {"speed_scale.factor", {factor, half_width}};
    return check;
  }
  check.state = excess(*worst) > certainly_wrong ? CheckState::fails : CheckState::warns;
  if (wrong == all && all > 1) check.recording = "all";
  constexpr double follows = 0.7;
  check.found = {"speed_scale.factor_in_recordings",
                 {factor, half_width, {"wrong", wrong}, {"recordings", all}}};
  check.found.add(
      worst->correlation < follows && std::abs(worst->factor) > 1e-3
          ? Statement{"speed_scale.does_not_follow_angle", {{"correlation", worst->correlation}}}
          : likely_cause_of_scale(worst->factor, worst->half_width,
                                  data.manifest->drive.gear_ratio()));
  check.consequence = {"speed_scale.every_speed_wrong"};
  check.experiment = {"speed_scale.correct_manifest"};
  return check;
}

// How much of the logged speed is noise: at low speed a two-point difference of a quantised angle
// is nothing else.

namespace {

/// Scatter of the logged speed about the slope of the angle, in % of the usual speed; < 0: unknown.
double noise_percent(const CheckedRecording& r) {
  const joint::Recording& log = *r.recording;
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
  return 100 * statistics::normal_sd_by_median_size * statistics::median(std::move(deviations)) /
         statistics::median(std::move(speeds));
}

}  // namespace

DataCheck check_speed_noise(const CheckedDataset& data) {
  constexpr double most_percent = 50;
  DataCheck check;
  check.name = CheckName::speed_noise;
  check.measure = {"measure.speed_scatter"};
  check.unit = percent_sign;
  check.at_most = most_percent;
  for (const CheckedRecording& r : data.recordings) {
    if (!r.travels()) continue;  // no stage reads a speed off a loop or a ramp
    const double noise = noise_percent(r);
    if (noise >= 0) take_if_worst(check, noise, r.recording->name);
  }
  if (!check.measured) {
    return not_applicable(check.name, {"not_applicable.no_speed_logged"});
  }
  check.found = {"speed_noise.scatters", {{"scatter_percent", *check.measured}}};
  check.state = *check.measured <= most_percent ? CheckState::passed : CheckState::warns;
  if (check.state == CheckState::passed) return check;
  check.found = {"speed_noise.hardly_more_than_steps", {{"scatter_percent", *check.measured}}};
  check.consequence = {"speed_noise.none_for_results"};
  check.experiment = {"speed_noise.differentiate_angle"};
  return check;
}

// How many different speeds the runs at constant speed hold.

DataCheck check_run_speeds(const CheckedDataset& data) {
  constexpr double least_ratio = 1.1;  // of a speed to the next slower one that it differs from
  constexpr std::size_t fewest = 5;    // the curve of eq. (6) has five parameters
  constexpr std::size_t fewest_for_a_line = 3;
  DataCheck check;
  check.name = CheckName::run_speeds;
  const auto runs = data.with_role(joint::Role::constant_speed);
  if (runs.empty()) return not_applicable(check.name, {"not_applicable.no_runs"});
  std::vector<double> speeds;
  for (const CheckedRecording* r : runs) {
    for (const motion::Plateau& plateau : r->motion.plateaus) {
      speeds.push_back(std::abs(plateau.speed_rad_s));
    }
  }
  std::sort(speeds.begin(), speeds.end());
  std::size_t different = 0;
  double last = 0;
  for (const double speed : speeds) {
    if (speed <= least_ratio * last) continue;
    ++different;
    last = speed;
  }
  check.recording = "all";
  check.measure = {"measure.different_speeds"};
  check.unit = pure_number;
  check.at_least = static_cast<double>(fewest);
  check.measured = static_cast<double>(different);
  check.found = {"run_speeds.plateaus", {{"plateaus", speeds.size()}, {"speeds", different}}};
  if (different >= fewest) {
    check.state = CheckState::passed;
    return check;
  }
  check.state = different >= fewest_for_a_line ? CheckState::warns : CheckState::fails;
  check.consequence = {"run_speeds.too_few"};
  check.experiment = {"run_speeds.record_ten_to_twenty"};
  return check;
}

}  // namespace tribolog::method::checks
