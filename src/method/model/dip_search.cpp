#include "method/model/dip_search.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <map>
#include <optional>
#include <utility>

namespace tribolog::method::model {
namespace {

/// Mean and standard deviation of the logarithm of a dip's parameter, by the evidence.
struct LogMean {
  double mean{};
  double sd{};
};
/// Absent: of none. @param laws a place each.
std::optional<LogMean> log_mean_of_dips(const WeighedLaws& weighed,
                                        const std::vector<std::size_t>& laws,
                                        double LawColumn::* parameter) {
  if (laws.empty()) return std::nullopt;
  double most = -std::numeric_limits<double>::infinity();
  for (const std::size_t k : laws) most = std::max(most, weighed.evidence[k]);
  double total = 0;
  double sum = 0;
  double square = 0;
  for (const std::size_t k : laws) {
    const double share = std::exp(weighed.evidence[k] - most);
    const double value = std::log(weighed.laws[k].dip.*parameter);
    total += share;
    sum += share * value;
    square += share * value * value;
  }
  const double mean = sum / total;
  return LogMean{mean, std::sqrt(std::max(0.0, square / total - mean * mean))};
}

/// Of the speeds of one grid, where the evidence is narrower than the grid: by the parabola
/// through the likeliest and its neighbours. Absent: it lies at an end.
std::optional<LogMean> between_dips(const WeighedLaws& weighed,
                                    const std::vector<std::size_t>& laws) {
  std::map<double, double> evidence;  // over the logarithm of the speed
  for (const std::size_t k : laws) {
    evidence[std::log(weighed.laws[k].dip.dip_speed)] = weighed.evidence[k];
  }
  const auto at =
      std::max_element(evidence.begin(), evidence.end(),
                       [](const auto& a, const auto& b) { return a.second < b.second; });
  if (at == evidence.end() || at == evidence.begin() || std::next(at) == evidence.end()) {
    return std::nullopt;
  }
  const double step = std::next(at)->first - at->first;
  const double before = std::prev(at)->second - at->second;
  const double after = std::next(at)->second - at->second;
  const double bend = before + after;
  if (!(bend < 0)) return std::nullopt;
  return LogMean{at->first + step * (before - after) / (2 * bend), step / std::sqrt(-bend)};
}

/// Dips of a grid about the likeliest, as far as their evidence reaches.
/// @param laws those of the grid. @param is_resolved false where the grid is coarser than that.
DipGrid nearer(const WeighedLaws& weighed, const DipGrid& grid,
               const std::vector<std::size_t>& laws, bool& is_resolved) {
  auto found = log_mean_of_dips(weighed, laws, &LawColumn::dip_speed);
  if (!found) return grid;
  if (found->sd > coarse_dip_step) return {grid.power};
  const double step = grid.step();
  double half_span = std::max(dips_each_side * found->sd, step);
  if (found->sd < step / 3) {
    is_resolved = false;
    if (const auto between = between_dips(weighed, laws)) {
      found = between;
      constexpr double most = 6;  // a parabola no further
      half_span = dips_each_side * std::max(between->sd, step / most);
    } else if (grid.near_rad_s > 0) {
      half_span = grid.half_span;  // at an end, and perhaps beyond
    }
  }
  return {grid.power, std::exp(found->mean), half_span};
}

/// A grid for this power, its speeds between those of the powers about it.
DipGrid between_powers(const std::vector<DipGrid>& grids, double power) {
  // Ascending powers; beyond the last one as it is between the last two.
  const auto same = std::find_if(grids.begin(), grids.end(),
                                 [&](const DipGrid& one) { return one.power == power; });
  if (same != grids.end()) return *same;
  std::size_t above = 1;
  while (above + 1 < grids.size() && grids[above].power < power) ++above;
  const DipGrid& a = grids[above - 1];
  const DipGrid& b = grids[above];
  if (!(a.near_rad_s > 0 && b.near_rad_s > 0)) return {power};
  constexpr double of_the_way = 0.2;  // speeds are no straight line over powers
  const double way = std::log(b.near_rad_s / a.near_rad_s);
  const double share = std::log(power / a.power) / std::log(b.power / a.power);
  return {power, a.near_rad_s * std::exp(share * way),
          std::max(std::min(a.half_span, b.half_span), of_the_way * std::abs(way))};
}

}  // namespace

void DipSearch::look_nearer(const WeighedLaws& weighed) {
  const auto likeliest = std::max_element(weighed.evidence.begin(), weighed.evidence.end());
  const FrictionLaw& best =
      weighed.laws[static_cast<std::size_t>(std::distance(weighed.evidence.begin(), likeliest))];
  if (!best.has_dip) {
    grids_ = coarse_dips();
    return;
  }
  bool is_resolved = true;
  std::vector<std::size_t> all;
  for (std::size_t form = 0; form < grids_.size(); ++form) {
    for (DipGrid& grid : grids_[form]) {
      std::vector<std::size_t> laws;
      for (std::size_t k = 0; k < weighed.laws.size(); ++k) {
        const FrictionLaw& law = weighed.laws[k];
        if (law.has_dip && law.form == form && law.dip.dip_power == grid.power) laws.push_back(k);
      }
      all.insert(all.end(), laws.begin(), laws.end());
      const bool is_best = form == best.form && grid.power == best.dip.dip_power;
      bool is_near = true;
      grid = nearer(weighed, grid, laws, is_near);
      if (is_best && !is_near) is_resolved = false;
    }
  }
  const auto of_power = log_mean_of_dips(weighed, all, &LawColumn::dip_power);
  if (is_resolved && of_power) refine_powers(best, of_power->sd);
}

void DipSearch::refine_powers(const FrictionLaw& best, double sd_of_power) {
  constexpr double coarse_step = 0.35;
  constexpr double finest_step = 0.06;
  constexpr int each_side = 2;
  if (sd_of_power > coarse_step) return;
  const double finer_step =
      std::clamp(sd_of_power, std::max(finest_step, power_step_ / 3), coarse_step);
  const std::vector<DipGrid>& found = grids_[best.form];
  const bool is_in_the_middle =
      found.size() == 2 * each_side + 1 && found[each_side].power == best.dip.dip_power;
  constexpr double alike = 1.5;
  if (is_in_the_middle && power_step_ < alike * finer_step && finer_step < alike * power_step_) {
    return;
  }
  power_step_ = finer_step;
  for (std::vector<DipGrid>& grids : grids_) {
    std::vector<DipGrid> finer;
    for (int k = -each_side; k <= each_side; ++k) {
      const double power = best.dip.dip_power * std::exp(k * power_step_);
      if (least_dip_power < power && power < most_dip_power) {
        finer.push_back(between_powers(grids, k == 0 ? best.dip.dip_power : power));
      }
    }
    grids = std::move(finer);
  }
}

}  // namespace tribolog::method::model
