#include "wording/units.h"

#include <cmath>
#include <utility>

#include "joint/degrees.h"

namespace tribolog::wording {
namespace {

// The prefix changes a decade below 1 so that "0.88 N·m" stays "0.88 N·m".
Scale prefixed(double size, double base_from, const char* unit) {
  const double absolute = std::abs(size);
  if (!std::isfinite(absolute) || absolute == 0.0 || absolute >= base_from) return {1.0, unit};
  if (absolute >= base_from * 1e-3) return {1e3, std::string("m") + unit};
  return {1e6, std::string("µ") + unit};
}

}  // namespace

Scale torque_scale(double size_Nm) { return prefixed(size_Nm, 0.1, "N·m"); }
Scale radian_scale(double size_rad) { return prefixed(size_rad, 0.01, "rad"); }
Scale viscous_scale(double size_Nms_rad) { return prefixed(size_Nms_rad, 0.1, "N·m·s/rad"); }
Scale stiffness_scale(double size_Nm_rad) {
  const double absolute = std::abs(size_Nm_rad);
  if (absolute >= 1e7) return {1e-6, "MN·m/rad"};
  return absolute >= 1e4 ? Scale{1e-3, "kN·m/rad"} : Scale{1.0, "N·m/rad"};
}

Scale degree_scale() { return {joint::degrees_per_rad, "°"}; }
Scale degree_per_second_scale() { return {joint::degrees_per_rad, "°/s"}; }
Scale plain_scale(std::string unit) { return {1.0, std::move(unit)}; }

Scale quantity_scale(const std::string& unit, double size) {
  if (unit == "rad") return degree_scale();
  if (unit == "N·m") return torque_scale(size);
  if (unit == "N·m/rad") return stiffness_scale(size);
  if (unit == "N·m·s/rad") return viscous_scale(size);
  return plain_scale(unit);
}

}  // namespace tribolog::wording
