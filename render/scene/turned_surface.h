#pragma once
// Surfaces of revolution, of which drums, arrows, balls and round links are made.

#include <vector>

#include "render/figure/scene_geometry.h"

namespace tribolog::render {

/// A corner of the outline that turns about the axis: `along` it and `away` from it.
struct ProfilePoint {
  double along{};
  double away{};
  double normal_along{};  ///< Unit normal of the surface.
  double normal_away{};
  double spread_along{};  ///< See SceneMesh::spread.
  double spread_away{};
};

/// Neighbouring points of a profile; consecutive pieces may differ in their normals at a shared
/// corner, which then is a sharp edge.
using ProfilePiece = std::vector<ProfilePoint>;

/// Adds the surface about the axis from `origin` in the direction `axis` (a unit vector). Pieces
/// run from back to front along the axis.
void add_turned_surface(SceneMesh& mesh, Point3 origin, Point3 axis,
                        const std::vector<ProfilePiece>& pieces);

/// Straight pieces with sharp edges through (along, away) corners.
std::vector<ProfilePiece> sharp_profile(const std::vector<PixelPoint>& corners);

/// The convex hull of two spheres on the axis, at 0 and at `distance`.
ProfilePiece round_profile(double distance, double radius_back, double radius_front);

}  // namespace tribolog::render
