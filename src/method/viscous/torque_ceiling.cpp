#include "method/viscous/torque_ceiling.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace tribolog::method::viscous {
namespace {

constexpr std::size_t fewest_on_ceiling = 3;
constexpr double same = 4;        // standard errors
constexpr double different = 10;  // the same
constexpr double far_apart = 5;   // times the spread of those on the ceiling

/// Runs with a known error and a partner, the largest torque in this direction first.
std::vector<const ConstantSpeedRun*> by_torque(const ViscousCurvesResult& curves, double sign) {
  std::vector<const ConstantSpeedRun*> runs;
  for (const ConstantSpeedRun& run : curves.runs) {
    const bool takes_part = run.partner >= 0 && run.torque_standard_error_Nm > 0;
    if (takes_part && sign * run.torque_Nm > 0) runs.push_back(&run);
  }
  std::stable_sort(runs.begin(), runs.end(), [&](const auto* a, const auto* b) {
    return sign * a->torque_Nm > sign * b->torque_Nm;
  });
  return runs;
}

}  // namespace

TorqueCeiling torque_ceiling(const ViscousCurvesResult& curves) {
  for (const double sign : {1.0, -1.0}) {
    const std::vector<const ConstantSpeedRun*> runs = by_torque(curves, sign);
    std::size_t count = 0;
    double lowest = INFINITY;
    double highest = -INFINITY;
    double largest_error = 0;
    for (const ConstantSpeedRun* run : runs) {
      const double error =
          std::hypot(run->torque_standard_error_Nm, runs.front()->torque_standard_error_Nm);
      if (sign * (runs.front()->torque_Nm - run->torque_Nm) > same * error) break;
      const double other = curves.runs[static_cast<std::size_t>(run->partner)].torque_Nm;
      lowest = std::min(lowest, other);
      highest = std::max(highest, other);
      largest_error = std::max(largest_error, run->torque_standard_error_Nm);
      ++count;
    }
    if (count < fewest_on_ceiling) continue;
    const double spread = std::abs(runs.front()->torque_Nm - runs[count - 1]->torque_Nm);
    if (highest - lowest > std::max(different * largest_error, far_apart * spread)) {
      return {count, runs.front()->torque_Nm};
    }
  }
  return {};
}

}  // namespace tribolog::method::viscous
