#pragma once
// Arithmetic of points and directions in space.

#include <cmath>

#include "render/figure/scene.h"

namespace tribolog::render {

inline Point3 operator+(Point3 a, Point3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Point3 operator-(Point3 a, Point3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Point3 operator*(double k, Point3 a) { return {k * a.x, k * a.y, k * a.z}; }
inline double dot(Point3 a, Point3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Point3 cross(Point3 a, Point3 b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double length(Point3 a) { return std::sqrt(dot(a, a)); }
inline Point3 unit(Point3 a) { return (1.0 / length(a)) * a; }

/// Some direction at a right angle to a unit vector.
inline Point3 any_across(Point3 a) {
  return unit(cross(a, std::abs(a.z) < 0.9 ? Point3{0, 0, 1} : Point3{1, 0, 0}));
}

/// `a` turned about the unit vector `axis`, right-handed (Rodrigues).
inline Point3 turned(Point3 a, Point3 axis, double angle_rad) {
  const double c = std::cos(angle_rad);
  return c * a + std::sin(angle_rad) * cross(axis, a) + ((1 - c) * dot(axis, a)) * axis;
}

}  // namespace tribolog::render
