#include "verdict/needs.h"

#include <cmath>
#include <optional>

#include "joint/degrees.h"

namespace tribolog::verdict {

using joint::Quantity;

namespace {

double usual_need(Quantity quantity) {
  switch (quantity) {
    case Quantity::cog_angle:
      return 0.5 * joint::rad_per_degree;
    case Quantity::gravity_torque:
      return 0.01;
    case Quantity::viscous_coefficient:
      return 0.15;
    case Quantity::inertia:
      return 0.25;
    case Quantity::bristle_damping:
      return 0.40;
    default:
      return 0.10;
  }
}

}  // namespace

double need_of(const calibration::Calibration& c, joint::Quantity quantity, double estimate) {
  std::optional<double> stated;
  for (const joint::AcceptanceLimit& limit : c.manifest.limits) {
    const joint::LimitedQuantity* of = joint::find_limited_quantity(limit.quantity);
    if (of == nullptr || of->quantity != quantity) continue;
    if (limit.half_width_percent) stated = *limit.half_width_percent / 100;
    if (limit.half_width) {
      const double factor = of->factor * std::pow(c.manifest.drive.gear_ratio(), of->gear_power);
      const double half_width = *limit.half_width / factor;
      stated = quantity == Quantity::cog_angle ? half_width : half_width / std::abs(estimate);
    }
  }
  return stated.value_or(usual_need(quantity));
}

double widest_with_stated(Quantity quantity) {
  if (quantity == Quantity::cog_angle) return 5 * joint::rad_per_degree;
  return quantity == Quantity::bristle_damping ? 0.4 : 0.3;
}

double widest_known(Quantity quantity) {
  return quantity == Quantity::cog_angle ? 30 * joint::rad_per_degree : 1;
}

}  // namespace tribolog::verdict
