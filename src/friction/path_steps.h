#pragma once
// Runge-Kutta along a piece of motion, for models that see its way rather than its time.

#include <algorithm>
#include <cmath>

#include "friction/speed_step.h"

namespace tribolog {

/// The end of a step, of so much way at most [rad]: what lies before has no effect on a contact
/// that forgets over a shorter way.
inline SpeedStep last_part_of(const SpeedStep& step, double way_rad) {
  const double whole = std::abs(step.path_rad());
  if (whole <= way_rad) return step;
  double low = 0;
  double high = 1;
  constexpr int halvings = 40;
  for (int i = 0; i < halvings; ++i) {
    const double middle = (low + high) / 2;
    (std::abs(step.part(middle, 1).path_rad()) > way_rad ? low : high) = middle;
  }
  return step.part(low, 1);
}

/// Integrates dy/dx = slope(y, speed) over the step's way x, counted in the direction of motion, in
/// equal shares of time none of which is longer than `longest_rad`. 4th order.
template <class Slope>
double integrate_along(const SpeedStep& step, double y, double longest_rad, const Slope& slope) {
  const double fastest =
      std::max({std::abs(step.start_rad_s), std::abs(step.middle_rad_s), std::abs(step.end_rad_s)});
  const double pieces = std::max(1.0, std::ceil(fastest * step.duration_s / longest_rad));
  const double h = 1 / pieces;
  const auto rate = [&](double share, double at) {
    const double speed = step.speed_rad_s(share);
    return std::abs(speed) * step.duration_s * slope(at, speed);
  };
  for (double k = 0; k < pieces; ++k) {
    const double share = k * h;
    const double k1 = rate(share, y);
    const double k2 = rate(share + h / 2, y + h / 2 * k1);
    const double k3 = rate(share + h / 2, y + h / 2 * k2);
    const double k4 = rate(share + h, y + h * k3);
    y += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
  }
  return y;
}

}  // namespace tribolog
