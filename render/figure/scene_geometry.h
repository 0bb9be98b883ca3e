#pragma once
// A laid-out scene: how space maps to the picture, and the surfaces of the solid parts.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "render/figure/pixel_geometry.h"
#include "render/figure/scene.h"

namespace tribolog::render {

/// A camera whose picture is fitted into the figure.
struct SceneView {
  Point3 eye;
  Point3 right;  ///< Unit vectors of the picture: right, up and away from the eye.
  Point3 up;
  Point3 forward;
  bool parallel{true};
  double scale{1.0};   ///< Pixels per metre, or, in perspective, at a distance of one metre.
  PixelPoint origin;   ///< Where the point straight ahead of the eye appears.
  double nearest_m{};  ///< Distances along `forward` between which everything lies.
  double farthest_m{};

  [[nodiscard]] double distance(Point3 p) const;
  [[nodiscard]] PixelPoint pixel(Point3 p) const;
  [[nodiscard]] double metres_per_pixel(Point3 p) const;
  /// Moves a point along its line of sight to a distance: it stays at the same pixel.
  [[nodiscard]] Point3 moved_to(Point3 p, double distance_m) const;
  /// Distances before and behind everything in the scene, for what must hide it or be hidden by it.
  [[nodiscard]] double front_m() const { return 0.5 * nearest_m; }
  [[nodiscard]] double back_m() const { return 1.02 * farthest_m; }

  /// The matrix, by rows, from the camera's coordinates (right, up, backwards) to the clip space of
  /// a window that shows `rows` rows of a picture `width` pixels wide from row `top` on.
  [[nodiscard]] std::array<double, 16> clip_matrix(int width, int top, int rows) const;
};

/// A part's surface as triangles.
struct SceneMesh {
  enum class Finish { lit, flat };  ///< Flat: the colour itself, seen from both sides, no outline.
  std::string label;                ///< Of the part; empty: nobody asks for it.
  Colour colour;                    ///< Opaque.
  Finish finish{Finish::lit};
  std::vector<Point3> points;
  std::vector<Point3> normals;  ///< For the light.
  std::vector<Point3> spread;   ///< Where the outline goes: outwards, also at sharp edges.
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< Counter-clockwise from outside.
};

struct SceneGeometry {
  SceneView view;
  std::vector<SceneMesh> meshes;
};

}  // namespace tribolog::render
