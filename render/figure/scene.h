#pragma once
// A three-dimensional drawing as plain data: lengths in metres, angles in radians, z upwards, axes
// right-handed. Parts are solid and hide each other; lines, arcs and texts are drawn over them.
//
// Texts use the markup of figure.h. A part with a `label` must be visible in the finished picture;
// one that other parts hide gives a warning. The alpha of a colour says how much of it is left on
// white paper: parts are never transparent.

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "render/figure/drawing_style.h"

namespace tribolog::render::figure {

struct Point3 {
  double x{};
  double y{};
  double z{};
  friend bool operator==(const Point3&, const Point3&) = default;
};

/// A link: two spheres and their convex hull; with `thickness_m`, a flat bar with round ends
/// instead that lies across `normal`.
struct SceneBody {
  std::string label;
  Point3 from;
  Point3 to;
  double from_radius_m{0.05};
  double to_radius_m{0.05};
  Colour colour{palette::grey};
  double thickness_m{0.0};  ///< 0: round.
  Point3 normal;            ///< Of a flat bar; at a right angle to its length.
};

/// The housing of a joint: a cylinder about its axis.
struct SceneDrum {
  std::string label;
  Point3 centre;
  Point3 axis;  ///< Direction, of any length but 0.
  double radius_m{0.05};
  double length_m{0.1};
  Colour colour{palette::grey};
};

/// A solid arrow; its label stands at the tip.
struct SceneArrow {
  std::string label;
  Point3 from;
  Point3 to;
  double radius_m{0.008};  ///< Of the shaft.
  Colour colour{palette::black};
};

/// A point mass.
struct SceneBall {
  std::string label;
  Point3 centre;
  double radius_m{0.03};
  Colour colour{palette::black};
  bool inside{false};  ///< Shown though it lies inside of another part.
};

enum class ArcEnds { plain, arrow_at_end, arrow_at_both };

/// An angle: the arc from `from_rad` to `to_rad` about `normal`, counted from `zero`.
struct SceneSector {
  std::string label;
  Point3 centre;
  Point3 normal;  ///< Right-handed: counter-clockwise seen against it.
  Point3 zero;    ///< Direction at a right angle to the normal.
  double radius_m{0.2};
  double from_rad{};
  double to_rad{};
  Colour colour{palette::blue};
  bool filled{false};  ///< Paints the sector with `fill`, behind everything else.
  Colour fill{palette::sky_blue.red, palette::sky_blue.green, palette::sky_blue.blue, 70};
  ArcEnds ends{ArcEnds::arrow_at_end};
};

/// A distance: a line with a head at both ends, moved away from what it measures by `shift`, and
/// the two thin lines that lead to it.
struct SceneDimension {
  std::string label;
  Point3 from;
  Point3 to;
  Point3 shift;
  Colour colour{palette::black};
};

/// A line on top of everything.
struct SceneLine {
  std::string label;
  std::vector<Point3> points;
  Colour colour{palette::black};
  double width_px{2.5};
  LineStyle style{LineStyle::solid};
};

/// A text beside a point.
struct SceneText {
  std::string text;
  Point3 at;
  Colour colour{palette::black};
};

/// A square grid on the floor.
struct SceneGround {
  Point3 centre;
  double half_size_m{1.0};
  double spacing_m{0.2};
};

struct SceneCamera {
  Point3 towards{0.0, 1.0, 0.0};  ///< Direction of view, of any length but 0.
  Point3 up{0.0, 0.0, 1.0};       ///< Not along the direction of view.
  double opening_deg{0.0};        ///< 0: parallel projection; else perspective, below 90.
  double margin{0.08};            ///< Share of the picture left free at each side, below 0.45.
  std::vector<Point3> fit;        ///< What must be in the picture; empty: every part.
};

struct Scene {
  SceneCamera camera;
  std::optional<SceneGround> ground;
  std::vector<SceneBody> bodies;
  std::vector<SceneDrum> drums;
  std::vector<SceneArrow> arrows;
  std::vector<SceneBall> balls;
  std::vector<SceneSector> sectors;
  std::vector<SceneDimension> dimensions;
  std::vector<SceneLine> lines;
  std::vector<SceneText> texts;
};

// Arithmetic of points and directions in space.

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

}  // namespace tribolog::render::figure
