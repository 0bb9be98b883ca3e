#include "history/fleet_distances.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <tuple>

#include "statistics/normal_score.h"
#include "statistics/robust_statistics.h"
#include "statistics/student_t.h"

namespace tribolog::archive {
namespace {

using GroupKey = std::tuple<std::string, double, std::string, std::size_t>;

/// Of the same joint and quantity.
using Group = std::vector<FleetCell*>;

std::optional<Distance> distance(const Estimate& latest, double median, std::size_t count,
                                 double scatter, double freedom) {
  const double widened =
      scatter * std::sqrt(1 + std::numbers::pi / (2 * static_cast<double>(count)));
  const double size = std::max(widened, latest.half_width() / normal_975);
  if (!(size > 0)) return std::nullopt;
  return Distance{history::normal_score((latest.value - median) / size, freedom), median, widened,
                  count};
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
  const double scatter = pairwise_scatter(latest);
  std::sort(latest.begin(), latest.end());
  for (FleetCell* cell : group) {
    const Estimate& e = cell->results.back().estimate;
    cell->to_others = distance(e, median_without(latest, e.value), group.size() - 1, scatter,
                               scatter_freedom(group.size()));
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
    const double median = median_of(earlier);
    const auto n = static_cast<double>(earlier.size());
    // About their own median they scatter less.
    for (const double x : earlier) deviations.push_back((x - median) * std::sqrt(n / (n - 1)));
  }
  if (deviations.empty()) return;
  const double scatter = pairwise_scatter(deviations);
  const double freedom = scatter_freedom(deviations.size() - joints + 1);
  for (FleetCell* cell : group) {
    const std::vector<double> earlier = earlier_of(*cell);
    if (earlier.size() < fewest_earlier) continue;
    cell->to_history = distance(cell->results.back().estimate, median_of(earlier), earlier.size(),
                                scatter, freedom);
  }
}

}  // namespace

void measure_distances(std::vector<FleetRobot>& robots) {
  std::map<GroupKey, Group> of_name;
  for (FleetRobot& robot : robots) {
    for (FleetJoint& joint : robot.joints) {
      const Facts& f = joint.latest.facts;
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

}  // namespace tribolog::archive
