#include "stages/encoder_resolution.h"

#include <algorithm>
#include <cmath>

#include "present.h"

#include "joint/degrees.h"
#include "stages/median.h"
#include "stages/plateaus.h"

namespace tribolog {
namespace {

bool is_multiple(double value, double step) {
  constexpr double whole_within = 0.05;
  const double multiple = value / step;
  return std::abs(multiple - std::round(multiple)) < whole_within;
}

bool nearly_all(std::size_t some, std::size_t all) {
  constexpr double share_needed = 0.95;
  return static_cast<double>(some) >= share_needed * static_cast<double>(all);
}

/// Whether nearly all of the angles, sorted and different, stand on a grid of this step, each on a
/// place of its own: a resting joint stands on any.
bool stand_on_grid(const std::vector<double>& angles, double step_rad) {
  std::size_t places = 0;
  double last = NAN;
  for (std::size_t i = 0; i < angles.size(); ++i) {
    // Of angles that know no such grid a few decide.
    if (!nearly_all(places + angles.size() - i, angles.size())) return false;
    const double place = std::round(angles[i] / step_rad);
    if (place == last || !is_multiple(angles[i], step_rad)) continue;
    last = place;
    ++places;
  }
  return nearly_all(places, angles.size());
}

/// The coarsest step of decimals that the angles stand on [rad]; 0: none.
double print_step_rad(std::vector<double> angles, double gear_ratio) {
  constexpr std::size_t fewest_angles = 20;
  constexpr int most_decimals = 6;
  std::sort(angles.begin(), angles.end());
  angles.erase(std::unique(angles.begin(), angles.end()), angles.end());
  if (angles.size() < fewest_angles) return 0;
  double coarsest = 0;
  for (const double unit_rad : {1.0, rad_per_degree, 1 / gear_ratio, rad_per_degree / gear_ratio}) {
    for (int decimals = 1; decimals <= most_decimals; ++decimals) {
      const double step = unit_rad * std::pow(10.0, -decimals);
      if (step <= coarsest) break;
      if (stand_on_grid(angles, step)) coarsest = step;
    }
  }
  return coarsest;
}

/// Travels of one recording, one per reversal.
void add_travels(const Recording& r, const std::vector<bool>& steady, const CogSweepResult& sweep,
                 double gear_ratio, std::vector<double>& travels) {
  const double coulomb = present(sweep.coulomb_Nm).value;
  // At a reversal acceleration is largest: without inertia friction would seem to turn over early.
  const double inertia = sweep.inertia_kgm2 ? sweep.inertia_kgm2->value * gear_ratio : 0.0;
  const std::vector<double> acceleration = find_plateaus(r).acceleration_rad_s2;
  const auto friction = [&](std::size_t i) {
    return r.torque_Nm[i] - sweep.offset_Nm - inertia * acceleration[i] -
           sweep.gravity_Nm.value * std::cos(r.q_rad[i] - sweep.q_peak_rad.value);
  };
  // A reversal is the unsteady stretch between two steady ones of opposite direction.
  for (std::size_t i = 1; i < r.size(); ++i) {
    if (steady[i] || !steady[i - 1]) continue;
    std::size_t end = i;
    while (end < r.size() && !steady[end]) ++end;
    const std::size_t reach = std::min(r.size(), end + (end - i));
    if (end == r.size() || i < 2) break;
    const double before = r.q_rad[i - 1] > r.q_rad[i - 2] ? 1.0 : -1.0;
    std::size_t turn = i;
    for (std::size_t k = i; k < end; ++k) {
      if (before * r.q_rad[k] > before * r.q_rad[turn]) turn = k;
    }
    for (std::size_t k = turn; k + 2 < reach; ++k) {
      const double mean = (friction(k) + friction(k + 1) + friction(k + 2)) / 3;
      if (before * mean < -0.7 * coulomb) {
        travels.push_back(std::abs(r.q_rad[k + 1] - r.q_rad[turn]));
        break;
      }
    }
    i = end;
  }
}

}  // namespace

double common_step(const std::vector<double>& values) {
  constexpr double largest_multiple = 1e4;  // beyond, whole multiples are a matter of chance
  std::vector<double> steps;
  double scale = 0;
  for (double value : values) scale = std::max(scale, std::abs(value));
  for (std::size_t i = 1; i < values.size(); ++i) {
    const double step = std::abs(values[i] - values[i - 1]);
    if (step > 1e-12 * scale) steps.push_back(step);
  }
  if (steps.size() < 10) return 0;
  const double smallest = *std::min_element(steps.begin(), steps.end());
  std::size_t whole = 0;
  for (double step : steps) {
    if (step < largest_multiple * smallest && is_multiple(step, smallest)) ++whole;
  }
  return nearly_all(whole, steps.size()) ? smallest : 0.0;
}

AngleStep angle_step(const std::vector<double>& q_rad, double gear_ratio) {
  constexpr double above = 1.5;  // a common step that is a few decimals wide is the encoder's
  const double common = common_step(q_rad);
  const double print = print_step_rad(q_rad, gear_ratio);
  if (print > 0 && !(common > above * print)) return {print, true};
  return {common, false};
}

std::optional<double> presliding_travel_rad(const CogSweepResult& sweep, double gear_ratio) {
  if (!sweep.found || !sweep.coulomb_Nm || !(sweep.coulomb_Nm->low > 0)) return std::nullopt;
  std::vector<double> travels;
  for (std::size_t k = 0; k < sweep.recordings.size(); ++k) {
    add_travels(*sweep.recordings[k], sweep.used[k], sweep, gear_ratio, travels);
  }
  if (travels.empty()) return std::nullopt;
  return median(std::move(travels));
}

}  // namespace tribolog
