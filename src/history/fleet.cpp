#include "history/fleet.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <tuple>
#include <utility>

#include "base/requirements.h"
#include "calibration/friction_speeds.h"
#include "calibration/read_calibration.h"
#include "statistics/distributions.h"
#include "statistics/order_statistics.h"

namespace tribolog::history {

// The distances of fleet.h.

namespace {

using GroupKey = std::tuple<std::string, double, std::string, std::size_t>;

/// Of the same joint and quantity.
using Group = std::vector<FleetCell*>;

std::optional<Distance> distance(const statistics::Estimate& latest, double median,
                                 std::size_t count, double scatter, double freedom) {
  const double widened =
      scatter * std::sqrt(1 + std::numbers::pi / (2 * static_cast<double>(count)));
  const double size = std::max(widened, latest.half_width() / statistics::normal_975);
  if (!(size > 0)) return std::nullopt;
  return Distance{statistics::normal_score((latest.value - median) / size, freedom), median,
                  widened, count};
}

/// Median of a sorted list without one of its elements.
double median_without(const std::vector<double>& sorted, double left_out) {
  const auto at = static_cast<std::size_t>(
      std::lower_bound(sorted.begin(), sorted.end(), left_out) - sorted.begin());
  const auto other = [&](std::size_t k) { return sorted[k < at ? k : k + 1]; };
  const std::size_t n = sorted.size() - 1;
  return n % 2 == 1 ? other(n / 2) : (other(n / 2 - 1) + other(n / 2)) / 2;
}

void hold_against_others(const Group& group) {
  if (group.size() < fewest_others + 1) return;
  std::vector<double> latest;
  for (const FleetCell* cell : group) latest.push_back(cell->results.back().estimate.value);
  const double scatter = statistics::pairwise_scatter(latest);
  std::sort(latest.begin(), latest.end());
  for (FleetCell* cell : group) {
    const statistics::Estimate& e = cell->results.back().estimate;
    cell->to_others = distance(e, median_without(latest, e.value), group.size() - 1, scatter,
                               statistics::scatter_freedom(group.size()));
  }
}

std::vector<double> earlier_of(const FleetCell& cell) {
  std::vector<double> earlier;
  for (std::size_t k = 0; k + 1 < cell.results.size(); ++k) {
    earlier.push_back(cell.results[k].estimate.value);
  }
  return earlier;
}

void hold_against_history(const Group& group) {
  std::vector<double> deviations;
  std::size_t joints = 0;
  for (const FleetCell* cell : group) {
    const std::vector<double> earlier = earlier_of(*cell);
    if (earlier.size() < fewest_earlier) continue;
    ++joints;
    const double median = statistics::median_of(earlier);
    const auto n = static_cast<double>(earlier.size());
    // About their own median they scatter less.
    for (const double x : earlier) deviations.push_back((x - median) * std::sqrt(n / (n - 1)));
  }
  if (deviations.empty()) return;
  const double scatter = statistics::pairwise_scatter(deviations);
  const double freedom = statistics::scatter_freedom(deviations.size() - joints + 1);
  for (FleetCell* cell : group) {
    const std::vector<double> earlier = earlier_of(*cell);
    if (earlier.size() < fewest_earlier) continue;
    cell->to_history = distance(cell->results.back().estimate, statistics::median_of(earlier),
                                earlier.size(), scatter, freedom);
  }
}

/// Fills to_others and to_history of all cells.
void measure_distances(std::vector<FleetRobot>& robots) {
  std::map<GroupKey, Group> of_name;
  for (FleetRobot& robot : robots) {
    for (FleetJoint& joint : robot.joints) {
      const calibration::Facts& f = joint.latest.facts;
      for (FleetCell& cell : joint.cells) {
        of_name[{f.of.joint, f.gear_ratio, f.of.robot, cell.column}].push_back(&cell);
      }
    }
  }
  std::map<GroupKey, Group> groups;
  for (const auto& [key, cells] : of_name) {
    GroupKey wider = key;
    if (cells.size() < fewest_others + 1) std::get<2>(wider).clear();
    Group& group = groups[wider];
    group.insert(group.end(), cells.begin(), cells.end());
  }
  for (const auto& [key, group] : groups) {
    hold_against_others(group);
    hold_against_history(group);
  }
}

constexpr double least_limit = 3.5;
constexpr double chance_outliers = 0.5;

/// What the data do not show is no result, also where there is a number.
bool is_result(const calibration::Quantity& q) {
  return !q.unit.empty() && q.estimate && q.verdict != calibration::Verdict::not_identifiable;
}

/// Columns in the order in which the calibrations have their quantities.
class Columns {
 public:
  /// @param friction the name of the one speed at which friction has a column.
  explicit Columns(std::string friction) : friction_(std::move(friction)) {}
  std::optional<std::size_t> of(const calibration::Quantity& q) {
    if (!is_result(q)) return std::nullopt;
    if (calibration::speed_of_friction(q.name) && q.name != friction_) return std::nullopt;
    const auto [at, is_new] = places_.try_emplace({q.name, q.unit}, all.size());
    if (is_new) all.push_back({q.name, q.words, q.unit});
    return at->second;
  }
  std::vector<FleetColumn> all;

 private:
  std::map<std::pair<std::string, std::string>, std::size_t> places_;  // by name and unit
  std::string friction_;
};

/// The speed at which most calibrations have their friction; of several the middle one. Empty:
/// none.
std::string friction_of_most(const std::vector<calibration::Measured>& measured) {
  std::map<double, std::size_t> count;
  for (const calibration::Measured& m : measured) {
    for (const calibration::Quantity& q : m.quantities) {
      const auto speed = calibration::speed_of_friction(q.name);
      if (speed && is_result(q)) ++count[*speed];
    }
  }
  std::size_t most = 0;
  for (const auto& [speed, times] : count) most = std::max(most, times);
  std::vector<double> speeds;
  for (const auto& [speed, times] : count) {
    if (times == most) speeds.push_back(speed);
  }
  return speeds.empty() ? "" : calibration::friction_name(speeds[speeds.size() / 2]);
}

/// The joint measured from `first` up to before `end`.
FleetJoint joint_of(std::vector<calibration::Measured>::const_iterator first,
                    std::vector<calibration::Measured>::const_iterator end, Columns& columns) {
  FleetJoint joint;
  joint.latest = (end - 1)->entry;
  joint.calibrations = static_cast<std::size_t>(end - first);
  for (const calibration::Quantity& q : (end - 1)->quantities) {
    const auto column = columns.of(q);
    if (column) joint.cells.push_back({*column, {}, q.verdict, {}, {}});
  }
  std::sort(joint.cells.begin(), joint.cells.end(),
            [](const FleetCell& a, const FleetCell& b) { return a.column < b.column; });
  for (auto at = first; at != end; ++at) {
    // What was measured behind another gear is no history of this one.
    if (at->entry.facts.gear_ratio != joint.latest.facts.gear_ratio) continue;
    const double time_s = calibration::seconds_of_utc(at->entry.facts.measured_at);
    for (FleetCell& cell : joint.cells) {
      for (const calibration::Quantity& q : at->quantities) {
        const FleetColumn& column = columns.all[cell.column];
        if (!is_result(q) || q.name != column.name || q.unit != column.unit) continue;
        cell.results.push_back({time_s, present(q.estimate)});
        break;
      }
    }
  }
  return joint;
}

void rank(Fleet& fleet) {
  for (FleetRobot& robot : fleet.robots) {
    for (FleetJoint& joint : robot.joints) {
      for (const FleetCell& cell : joint.cells) {
        fleet.distances += (cell.to_others ? 1U : 0U) + (cell.to_history ? 1U : 0U);
        joint.furthest = std::max(joint.furthest, cell.furthest());
      }
      robot.furthest = std::max(robot.furthest, joint.furthest);
    }
  }
  std::stable_sort(
      fleet.robots.begin(), fleet.robots.end(),
      [](const FleetRobot& a, const FleetRobot& b) { return a.furthest > b.furthest; });
  fleet.limit = least_limit;
  if (fleet.distances > 0) {
    fleet.limit =
        std::max(fleet.limit,
                 statistics::deviate_of(chance_outliers / static_cast<double>(fleet.distances)));
  }
}

}  // namespace

double FleetCell::furthest() const {
  return std::max(to_others ? std::abs(to_others->z) : 0, to_history ? std::abs(to_history->z) : 0);
}

Fleet fleet_of(const std::vector<calibration::Measured>& measured,
               const calibration::Decisions& decisions) {
  Fleet fleet;
  Columns columns(friction_of_most(measured));
  for (auto first = measured.begin(); first != measured.end();) {
    const calibration::JointName& of = first->entry.facts.of;
    const auto end = std::find_if(first, measured.end(), [&](const calibration::Measured& m) {
      return m.entry.facts.of != of;
    });
    const bool is_same_robot = !fleet.robots.empty() && fleet.robots.back().robot == of.robot &&
                               fleet.robots.back().serial == of.serial;
    if (!is_same_robot) fleet.robots.push_back({of.robot, of.serial, {}, 0});
    FleetJoint& joint = fleet.robots.back().joints.emplace_back(joint_of(first, end, columns));
    const auto decision = decisions.find(joint.latest.id);
    if (decision != decisions.end()) joint.decision = decision->second;
    for (auto at = first; at != end; ++at) {
      const double time_s = calibration::seconds_of_utc(at->entry.facts.measured_at);
      fleet.first_s = fleet.calibrations == 0 ? time_s : std::min(fleet.first_s, time_s);
      fleet.last_s = fleet.calibrations == 0 ? time_s : std::max(fleet.last_s, time_s);
      ++fleet.calibrations;
    }
    ++fleet.joints;
    first = end;
  }
  fleet.columns = columns.all;
  measure_distances(fleet.robots);
  rank(fleet);
  return fleet;
}

}  // namespace tribolog::history
