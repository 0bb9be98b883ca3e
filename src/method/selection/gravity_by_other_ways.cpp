#include "method/selection/gravity_by_other_ways.h"

#include <algorithm>

#include "method/selection/classical_regression.h"
#include "method/selection/direction_means.h"

namespace tribolog {

const GravityByOtherWay* OtherWays::find(const std::string& method) const {
  const auto it = std::find_if(gravity.begin(), gravity.end(),
                               [&](const GravityByOtherWay& g) { return g.method == method; });
  return it == gravity.end() ? nullptr : &*it;
}

OtherWays gravity_by_other_ways(const std::vector<const Recording*>& sweeps,
                                const std::vector<const Recording*>& runs,
                                const CogSweepResult& rough, const ViscousCurvesResult& curves,
                                const std::optional<Estimate>& q_peak_rad, double gear_ratio) {
  OtherWays out;
  if (auto way = gravity_of_sweep_directions(rough, gear_ratio))
    out.gravity.push_back(std::move(*way));
  if (q_peak_rad) {
    if (auto way = gravity_of_run_directions(curves)) out.gravity.push_back(std::move(*way));
    std::vector<const Recording*> moving = sweeps;
    moving.insert(moving.end(), runs.begin(), runs.end());
    if (auto fit = classical_regression(moving, gear_ratio, q_peak_rad->value)) {
      out.gravity.push_back(std::move(fit->gravity));
      out.classical = std::move(fit->regression);
    }
  }
  return out;
}

}  // namespace tribolog
