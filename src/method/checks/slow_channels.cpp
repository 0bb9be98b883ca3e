// A channel that was sampled more slowly than it is logged: its values are held, or lie on straight
// lines from one sample to the next.

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "method/checks/check_list.h"
#include "method/motion/encoder_resolution.h"
#include "statistics/order_statistics.h"

namespace tribolog::method::checks {

namespace {

constexpr std::size_t fewest_bends = 50;

/// That of equidistant samples, a few of which may be missing. 1: they are not.
std::size_t usual_distance(const std::vector<double>& apart) {
  constexpr double regular = 0.95;
  if (apart.size() < fewest_bends) return 1;
  const double usual = statistics::median(apart);
  if (usual == 1) return 1;
  const auto multiples = std::count_if(apart.begin(), apart.end(),
                                       [&](double n) { return std::remainder(n, usual) == 0; });
  const bool is_regular =
      static_cast<double>(multiples) >= regular * static_cast<double>(apart.size());
  return is_regular ? static_cast<std::size_t>(usual) : 1;
}

/// Number of samples between bends of a channel's course, where these are equidistant and the
/// course is straight in between: by this factor it was sampled more slowly than logged. 1: it was
/// not.
std::size_t samples_between_bends(const std::vector<double>& t_s,
                                  const std::vector<double>& values) {
  constexpr double straight = 1e-3;      // of a large change of the slope
  constexpr double large = 0.995;        // quantile
  constexpr double least_scatter = 0.1;  // of the changes: bends all alike are those of a command
  std::vector<double> change(values.size());
  const auto slope = [&](std::size_t i) {
    return (values[i + 1] - values[i]) / (t_s[i + 1] - t_s[i]);
  };
  for (std::size_t i = 1; i + 1 < values.size(); ++i) {
    change[i] = std::abs(slope(i) - slope(i - 1));
  }
  std::vector<double> sorted;
  for (const double c : change) {
    if (std::isfinite(c)) sorted.push_back(c);
  }
  if (sorted.size() < fewest_bends) return 1;
  const double least = straight * statistics::value_at_share(std::move(sorted), large);
  if (!(least > 0)) return 1;
  std::vector<double> apart;
  std::vector<double> bends;
  std::size_t before = 0;
  for (std::size_t i = 1; i + 1 < values.size(); ++i) {
    if (!(change[i] > least)) continue;
    if (before > 0) apart.push_back(static_cast<double>(i - before));
    bends.push_back(change[i]);
    before = i;
  }
  const std::size_t distance = usual_distance(apart);
  if (distance == 1) return 1;
  const double usual = statistics::median(bends);
  std::vector<double> from_usual;
  for (const double bend : bends) from_usual.push_back(std::abs(bend - usual));
  return statistics::median(std::move(from_usual)) < least_scatter * usual ? 1 : distance;
}

/// The same of a channel that is held: it changes by many steps of its resolution, and stands
/// between.
std::size_t samples_between_steps(const std::vector<double>& values, double resolution) {
  constexpr double many = 2.5;
  std::vector<double> apart;
  std::size_t before = 0;
  for (std::size_t i = 0; i + 1 < values.size(); ++i) {
    const double step = std::abs(values[i + 1] - values[i]);
    if (step == 0) continue;
    if (step > many * resolution && before > 0) apart.push_back(static_cast<double>(i - before));
    before = i;
  }
  return usual_distance(apart);
}

struct SlowChannel {
  double interval_s{};  ///< Of the log.
  bool is_held{};
};

/// Puts the slowest of the recordings' channels into the check.
/// @param channel its values and its resolution in a recording.
template <typename Channel>
SlowChannel take_slowest(const CheckedDataset& data, Channel channel, DataCheck& check) {
  SlowChannel slowest;
  for (const CheckedRecording& r : data.recordings) {
    const std::pair<const std::vector<double>&, double> of = channel(r);
    const std::size_t bends = samples_between_bends(r.recording->t_s, of.first);
    const std::size_t steps = samples_between_steps(of.first, of.second);
    if (!take_if_worst(check, static_cast<double>(std::max(bends, steps)), r.recording->name)) {
      continue;
    }
    slowest = {r.interval_s, steps > bends};
  }
  return slowest;
}

Statement found(const DataCheck& check, const SlowChannel& slowest, Code held, Code straight) {
  return {slowest.is_held ? held : straight,
          {{"samples", static_cast<std::size_t>(*check.measured)},
           {"interval_ms", 1e3 * slowest.interval_s * *check.measured}}};
}

}  // namespace

DataCheck check_angle_interpolated(const CheckedDataset& data) {
  constexpr double most = 2;
  DataCheck check;
  check.name = CheckName::angle_interpolated;
  check.measure = {"measure.samples_between_bends"};
  check.unit = pure_number;
  check.at_most = most;
  const SlowChannel slowest = take_slowest(
      data,
      [](const CheckedRecording& r) {
        return std::pair<const std::vector<double>&, double>(r.recording->q_rad, r.angle_step_rad);
      },
      check);
  if (!check.measured) return not_applicable(check.name, {"not_applicable.no_recording"});
  if (*check.measured <= most) return passed_by_all(check, {"angle_interpolated.is_not"});
  check.state = CheckState::fails;
  check.found = found(check, slowest, {"angle_interpolated.held_between"},
                      {"angle_interpolated.straight_between"});
  check.consequence = {"angle_interpolated.bends_acceleration"};
  check.experiment = {"angle_interpolated.log_each_sample"};
  return check;
}

// A torque that comes seldom is late by half of its interval as a mean: what that costs the other
// numbers, the rules on lag and loops say.
DataCheck check_torque_interpolated(const CheckedDataset& data) {
  constexpr double most = 2;
  constexpr double most_harmless = 4;
  DataCheck check;
  check.name = CheckName::torque_interpolated;
  if (!data.has_torque) return not_applicable(check.name, {"not_applicable.no_torque"});
  check.measure = {"measure.samples_between_torque_bends"};
  check.unit = pure_number;
  check.at_most = most;
  const SlowChannel slowest = take_slowest(
      data,
      [](const CheckedRecording& r) {
        const std::vector<double>& torque = r.recording->torque_Nm;
        return std::pair<const std::vector<double>&, double>(torque, motion::common_step(torque));
      },
      check);
  if (!check.measured) return not_applicable(check.name, {"not_applicable.no_recording"});
  if (*check.measured <= most) return passed_by_all(check, {"torque_interpolated.is_not"});
  check.state = passed_or_warns_up_to(most_harmless, check);
  check.found = found(check, slowest, {"torque_interpolated.held_between"},
                      {"torque_interpolated.straight_between"});
  check.consequence = {"torque_interpolated.is_late"};
  check.experiment = {"angle_interpolated.log_each_sample"};
  return check;
}

}  // namespace tribolog::method::checks
