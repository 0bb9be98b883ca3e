#include "method/motion/encoder_resolution.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "joint/degrees.h"

namespace tribolog::method::motion {
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

/// Whether nearly all of the angles, sorted and distinct, lie on a grid of this step, each at a
/// point of its own: a resting joint would fit any.
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

/// The coarsest step of decimals on which the angles lie [rad]; 0: none.
double print_step_rad(std::vector<double> angles, double gear_ratio) {
  constexpr std::size_t fewest_angles = 20;
  constexpr int most_decimals = 6;
  constexpr std::size_t enough_angles = 4096;
  if (angles.size() > enough_angles) {  // some tell as much as all
    const std::size_t stride = 1 + (angles.size() - 1) / enough_angles;
    for (std::size_t k = 0; k * stride < angles.size(); ++k) angles[k] = angles[k * stride];
    angles.resize(1 + (angles.size() - 1) / stride);
  }
  std::sort(angles.begin(), angles.end());
  angles.erase(std::unique(angles.begin(), angles.end()), angles.end());
  if (angles.size() < fewest_angles) return 0;
  double coarsest = 0;
  for (const double unit_rad :
       {1.0, joint::rad_per_degree, 1 / gear_ratio, joint::rad_per_degree / gear_ratio}) {
    for (int decimals = 1; decimals <= most_decimals; ++decimals) {
      const double step = unit_rad * std::pow(10.0, -decimals);
      if (step <= coarsest) break;
      if (stand_on_grid(angles, step)) coarsest = step;
    }
  }
  return coarsest;
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

}  // namespace tribolog::method::motion
