// Does friction change during the measurement, as when the gear warms up?
//
// Strokes that repeat each other within one recording are compared: half the difference between
// each rising stroke and the adjacent falling one, at equal angle, over time.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "base/requirements.h"
#include "method/checks/check_list.h"
#include "statistics/distributions.h"
#include "statistics/order_statistics.h"

namespace tribolog::method::checks {
namespace {

constexpr std::size_t drift_bins = 12;
constexpr std::size_t fewest_pairs = 3;
constexpr double same_travel = 0.8;

using BinMeans = std::array<double, drift_bins>;

/// Mean torque in equal bins of the angle between low and high; NaN where the stroke has no sample.
BinMeans means_over_angle(const joint::Recording& r, const motion::Stroke& stroke, double low,
                          double high) {
  std::array<double, drift_bins> sum{};
  std::array<std::size_t, drift_bins> count{};
  for (std::size_t i = stroke.first; i < stroke.last; ++i) {
    const double place = (r.q_rad[i] - low) / (high - low);
    if (!(place >= 0 && place < 1)) continue;
    const auto k = static_cast<std::size_t>(place * drift_bins);
    sum[k] += r.torque_Nm[i];
    ++count[k];
  }
  for (std::size_t k = 0; k < drift_bins; ++k) {
    sum[k] = count[k] > 0 ? sum[k] / static_cast<double>(count[k])
                          : std::numeric_limits<double>::quiet_NaN();
  }
  return sum;
}

struct FrictionAt {
  double t_s{};
  double friction_Nm{};
};

std::vector<FrictionAt> friction_over_time(const CheckedRecording& r) {
  std::vector<double> travels;
  for (const motion::Stroke& stroke : r.strokes) travels.push_back(stroke.travel_rad);
  std::vector<motion::Stroke> alike;
  const double usual = statistics::median(travels);
  for (const motion::Stroke& stroke : r.strokes) {
    if (stroke.travel_rad > same_travel * usual && stroke.travel_rad < usual / same_travel) {
      alike.push_back(stroke);
    }
  }
  // The first stroke of an oscillation starts from rest, not from a turn.
  if (r.recording->role == joint::Role::oscillation && !alike.empty()) alike.erase(alike.begin());
  const double margin = 0.1 * r.range_rad();
  std::vector<FrictionAt> found;
  for (std::size_t k = 0; k + 1 < alike.size(); k += 2) {
    if (alike[k].direction == alike[k + 1].direction) continue;
    const double low = r.lowest_rad + margin;
    const double high = r.highest_rad - margin;
    const BinMeans first = means_over_angle(*r.recording, alike[k], low, high);
    const BinMeans second = means_over_angle(*r.recording, alike[k + 1], low, high);
    double sum = 0, count = 0;
    for (std::size_t b = 0; b < drift_bins; ++b) {
      const double half = alike[k].direction * (first[b] - second[b]) / 2;
      if (!std::isfinite(half)) continue;
      sum += half;
      count += 1;
    }
    if (count < drift_bins / 2.0) continue;
    found.push_back({r.recording->t_s[alike[k].last], sum / count});
  }
  return found;
}

struct Drift {
  double percent{};  ///< Of the mean, from the first pair to the last.
  bool is_certain{};
  double first_Nm{}, last_Nm{};  ///< On the straight line.
  double duration_s{};
  std::size_t pairs{};
};

/// Whether a loop is so thin for its height that the contact hardly slid: half its height is then
/// what a spring holds, and the change of the little rest says nothing of friction.
bool is_thin_loop(const joint::Recording& r, double friction_Nm) {
  constexpr double thin = 0.2;
  if (r.role != joint::Role::oscillation) return false;
  const auto [low, high] = std::minmax_element(r.torque_Nm.begin(), r.torque_Nm.end());
  return friction_Nm < thin * (*high - *low) / 2;
}

std::optional<Drift> drift_of(const CheckedRecording& r) {
  const std::vector<FrictionAt> points = friction_over_time(r);
  if (points.size() < fewest_pairs) return std::nullopt;
  const auto n = static_cast<double>(points.size());
  double t = 0, f = 0, tt = 0, tf = 0, squares = 0;
  for (const FrictionAt& p : points) {
    t += p.t_s / n;
    f += p.friction_Nm / n;
  }
  if (!(f > 0) || is_thin_loop(*r.recording, f)) return std::nullopt;
  for (const FrictionAt& p : points) {
    tt += std::pow(p.t_s - t, 2);
    tf += (p.t_s - t) * (p.friction_Nm - f);
  }
  const double slope = tf / tt;
  for (const FrictionAt& p : points) {
    squares += std::pow(p.friction_Nm - f - slope * (p.t_s - t), 2);
  }
  const double error = n > 2 ? std::sqrt(squares / (n - 2) / tt) : 0.0;
  Drift drift;
  drift.duration_s = points.back().t_s - points.front().t_s;
  drift.percent = 100 * std::abs(slope) * drift.duration_s / f;
  drift.is_certain = std::abs(slope) > statistics::student_t_975(n - 2) * error;
  drift.first_Nm = f + slope * (points.front().t_s - t);
  drift.last_Nm = f + slope * (points.back().t_s - t);
  drift.pairs = points.size();
  return drift;
}

}  // namespace

DataCheck check_friction_drift(const CheckedDataset& data) {
  constexpr double warning_percent = 10;
  constexpr double most_percent = 20;
  DataCheck check;
  check.name = CheckName::friction_drift;
  if (!data.has_torque) {
    return not_applicable(check.name, {"not_applicable.no_torque"});
  }
  check.measure = {"measure.friction_change"};
  check.unit = percent_sign;
  check.at_most = warning_percent;
  std::optional<Drift> worst;
  for (const CheckedRecording& r : data.recordings) {
    const auto drift = drift_of(r);
    if (!drift) continue;
    const double percent = drift->is_certain ? drift->percent : 0.0;
    if (worst && percent <= present(check.measured)) continue;
    worst = drift;
    check.measured = percent;
    check.recording = r.recording->name;
  }
  if (!worst) {
    return not_applicable(check.name, {"not_applicable.strokes_not_repeated"});
  }
  check.found = {"friction_drift.over_strokes",
                 {{"first_Nm", worst->first_Nm},
                  {"last_Nm", worst->last_Nm},
                  {"duration_s", worst->duration_s},
                  {"pairs", worst->pairs}}};
  check.state = passed_or_warns_up_to(most_percent, check);
  if (check.state == CheckState::passed) return check;
  check.consequence = {"friction_drift.no_one_temperature"};
  check.experiment = {"friction_drift.warm_up"};
  return check;
}

}  // namespace tribolog::method::checks
