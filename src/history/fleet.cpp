#include "history/fleet.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/present.h"
#include "calibration/entry_of_calibration.h"
#include "history/fleet_distances.h"
#include "statistics/robust_statistics.h"

namespace tribolog::archive {
namespace {

constexpr double least_limit = 3.5;
constexpr double chance_outliers = 0.5;

/// What the data do not show is no result, also where there is a number.
bool is_result(const Quantity& q) {
  return !q.unit.empty() && q.estimate && q.verdict != Verdict::not_identifiable;
}

/// Columns in the order in which the calibrations have their quantities.
class Columns {
 public:
  std::optional<std::size_t> of(const Quantity& q) {
    if (!is_result(q)) return std::nullopt;
    const auto [at, is_new] = places_.try_emplace(q.name, all.size());
    if (is_new) all.push_back({q.name, q.words, q.unit});
    return at->second;
  }
  std::vector<FleetColumn> all;

 private:
  std::map<std::string, std::size_t> places_;
};

/// The joint measured from `first` up to before `end`.
FleetJoint joint_of(std::vector<Measured>::const_iterator first,
                    std::vector<Measured>::const_iterator end, Columns& columns) {
  FleetJoint joint;
  joint.latest = (end - 1)->entry;
  joint.calibrations = static_cast<std::size_t>(end - first);
  for (const Quantity& q : (end - 1)->quantities) {
    const auto column = columns.of(q);
    if (column) joint.cells.push_back({*column, {}, q.verdict, {}, {}});
  }
  std::sort(joint.cells.begin(), joint.cells.end(),
            [](const FleetCell& a, const FleetCell& b) { return a.column < b.column; });
  for (auto at = first; at != end; ++at) {
    // What was measured behind another gear is no history of this one.
    if (at->entry.facts.gear_ratio != joint.latest.facts.gear_ratio) continue;
    const double time_s = seconds_of_utc(at->entry.facts.measured_at);
    for (FleetCell& cell : joint.cells) {
      for (const Quantity& q : at->quantities) {
        if (!is_result(q) || q.name != columns.all[cell.column].name) continue;
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
        std::max(fleet.limit, deviate_of(chance_outliers / static_cast<double>(fleet.distances)));
  }
}

}  // namespace

double FleetCell::furthest() const {
  return std::max(to_others ? std::abs(to_others->z) : 0, to_history ? std::abs(to_history->z) : 0);
}

Fleet fleet_of(const std::vector<Measured>& measured, const Decisions& decisions) {
  Fleet fleet;
  Columns columns;
  for (auto first = measured.begin(); first != measured.end();) {
    const JointName& of = first->entry.facts.of;
    const auto end = std::find_if(first, measured.end(),
                                  [&](const Measured& m) { return m.entry.facts.of != of; });
    const bool is_same_robot = !fleet.robots.empty() && fleet.robots.back().robot == of.robot &&
                               fleet.robots.back().serial == of.serial;
    if (!is_same_robot) fleet.robots.push_back({of.robot, of.serial, {}, 0});
    FleetJoint& joint = fleet.robots.back().joints.emplace_back(joint_of(first, end, columns));
    const auto decision = decisions.find(joint.latest.id);
    if (decision != decisions.end()) joint.decision = decision->second;
    for (auto at = first; at != end; ++at) {
      const double time_s = seconds_of_utc(at->entry.facts.measured_at);
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

}  // namespace tribolog::archive
