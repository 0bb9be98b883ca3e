// Is there a signal in the torque at all?

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "method/checks/check_list.h"
#include "statistics/white_noise.h"

namespace tribolog {
namespace {

/// Sums of one role's torque: its own variance and that of its white part.
struct TorqueScatter {
  double sum{}, squares{}, count{};
  std::vector<double> third;

  void add(const std::vector<double>& t) {
    for (const double torque : t) {
      sum += torque;
      squares += torque * torque;
      count += 1;
    }
    const std::vector<double> more = third_differences(t);
    third.insert(third.end(), more.begin(), more.end());
  }
  /// White noise shows in third differences; a signal of a robot does not.
  [[nodiscard]] double white_percent() const {
    const double variance = squares / count - std::pow(sum / count, 2);
    if (!(variance > 0)) return 0;
    return std::min(100.0, 100 * white_variance(third) / variance);
  }
};

}  // namespace

DataCheck check_torque_alive(const CheckedDataset& data) {
  DataCheck check;
  check.name = "torque_alive";
  check.title = "The torque changes";
  if (!data.has_torque) {
    return not_applicable(check.name, check.title, "no torque was recorded");
  }
  check.measure = "recordings in which the torque changes";
  check.unit = percent_sign;
  check.at_least = 100;
  RecordingsAsWanted alive;
  for (const CheckedRecording& r : data.recordings) {
    const std::vector<double>& t = r.recording->torque_Nm;
    const auto [low, high] = std::minmax_element(t.begin(), t.end());
    alive.add(!t.empty() && *high > *low, r.recording->name);
  }
  if (alive.all() == 0) return not_applicable(check.name, check.title, "no recording");
  alive.take_share(check);
  if (alive.others() == 0) return passed_by_all(check, "the torque changes in every recording");
  check.state = CheckState::fails;
  check.found =
      fmt::format("the torque is one constant number in {} of {} recordings: a dead sensor?",
                  alive.others(), alive.all());
  check.consequence = "a torque that does not change shows neither gravity nor friction";
  check.experiment = "see that the torque's column is alive before the next measurement";
  return check;
}

DataCheck check_torque_noise(const CheckedDataset& data) {
  constexpr double warning_percent = 50;
  constexpr double most_percent = 80;
  DataCheck check;
  check.name = "torque_noise";
  check.title = "Signal in the torque";
  if (!data.has_torque) {
    return not_applicable(check.name, check.title, "no torque was recorded");
  }
  check.measure = "share of white noise in the variance of the torque";
  check.unit = percent_sign;
  check.at_most = warning_percent;
  for (const Role role : {Role::rough_sweep, Role::oscillation, Role::constant_speed}) {
    const auto recordings = data.with_role(role);
    if (recordings.empty()) continue;
    TorqueScatter scatter;
    for (const CheckedRecording* r : recordings) scatter.add(r->recording->torque_Nm);
    const double percent = scatter.white_percent();
    take_if_worst(
        check, percent,
        recordings.size() == 1 ? recordings.front()->recording->name : to_string(role) + ", all");
  }
  if (!check.measured) {
    return not_applicable(check.name, check.title, "no sweep, oscillation or run");
  }
  check.found = fmt::format("{:.2g} % of the torque's variance is white noise", *check.measured);
  check.state = passed_or_warns_up_to(most_percent, check);
  if (check.state == CheckState::passed) return check;
  check.consequence =
      "what is left of gravity and friction drowns in it; the intervals are as "
      "wide as that";
  check.experiment =
      "record for longer, or filter the current in the drive; see that the column "
      "is the torque";
  return check;
}

}  // namespace tribolog
