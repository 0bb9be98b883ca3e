#include "render/scene/turned_surface.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "render/figure/vector3.h"

namespace tribolog::render {
namespace {

constexpr int segments = 64;   // about the axis
constexpr int cap_steps = 12;  // of a round end, from its pole on
constexpr double pi = std::numbers::pi;

}  // namespace

void add_turned_surface(SceneMesh& mesh, Point3 origin, Point3 axis,
                        const std::vector<ProfilePiece>& pieces) {
  const Point3 across = any_across(axis);
  const Point3 third = cross(axis, across);
  for (const ProfilePiece& piece : pieces) {
    const auto first = static_cast<std::uint32_t>(mesh.points.size());
    for (const ProfilePoint& p : piece) {
      for (int i = 0; i < segments; ++i) {
        const double angle = 2 * pi * i / segments;
        const Point3 out = std::cos(angle) * across + std::sin(angle) * third;
        mesh.points.push_back(origin + p.along * axis + p.away * out);
        mesh.normals.push_back(p.normal_along * axis + p.normal_away * out);
        mesh.spread.push_back(p.spread_along * axis + p.spread_away * out);
      }
    }
    for (std::uint32_t ring = 0; ring + 1 < piece.size(); ++ring) {
      for (std::uint32_t i = 0; i < segments; ++i) {
        const std::uint32_t next = (i + 1) % segments;
        const std::uint32_t a = first + ring * segments + i;
        const std::uint32_t b = first + ring * segments + next;
        if (piece[ring].away > 0) mesh.triangles.push_back({a, b, a + segments});
        if (piece[ring + 1].away > 0) mesh.triangles.push_back({b, b + segments, a + segments});
      }
    }
  }
}

std::vector<ProfilePiece> sharp_profile(const std::vector<PixelPoint>& corners) {
  std::vector<PixelPoint> normals;
  for (std::size_t i = 1; i < corners.size(); ++i) {
    const double along = corners[i].x - corners[i - 1].x;
    const double away = corners[i].y - corners[i - 1].y;
    const double size = std::hypot(along, away);
    normals.push_back({-away / size, along / size});
  }
  std::vector<ProfilePiece> pieces;
  for (std::size_t i = 0; i < normals.size(); ++i) {
    ProfilePiece piece;
    for (const std::size_t end : {i, i + 1}) {
      const PixelPoint n = normals[i];
      PixelPoint spread = n;
      if (corners[end].y == 0) {
        // All points of a tip must move alike, or the outline gapes there.
        constexpr double farthest = 3.0;
        const double out = std::min(farthest, 1.0 / std::max(1e-9, std::abs(n.x)));
        spread = {std::copysign(out, n.x), 0.0};
      }
      const bool has_neighbour = end > 0 && end < normals.size();
      if (has_neighbour) {
        const PixelPoint other = normals[end == i ? i - 1 : i + 1];
        const double share = 1.0 / std::max(0.5, 1.0 + n.x * other.x + n.y * other.y);
        spread = {(n.x + other.x) * share, (n.y + other.y) * share};
      }
      piece.push_back({corners[end].x, corners[end].y, n.x, n.y, spread.x, spread.y});
    }
    pieces.push_back(std::move(piece));
  }
  return pieces;
}

ProfilePiece round_profile(double distance, double radius_back, double radius_front) {
  const double slope =
      distance > 0 ? std::clamp((radius_back - radius_front) / distance, -1.0, 1.0) : 0.0;
  const double seam = std::acos(slope);  // where the cone touches the spheres, from the front pole
  ProfilePiece profile;
  const auto add = [&](double centre, double radius, double angle) {
    const double along = std::cos(angle);
    const double away = std::max(0.0, std::sin(angle));
    profile.push_back({centre + radius * along, radius * away, along, away, along, away});
  };
  for (int i = 0; i <= cap_steps; ++i) {
    add(0.0, radius_back, i == 0 ? pi : pi - (pi - seam) * i / cap_steps);
  }
  for (int i = 0; i <= cap_steps; ++i) {
    add(distance, radius_front, i == cap_steps ? 0.0 : seam - seam * i / cap_steps);
  }
  profile.front().away = 0;
  profile.back().away = 0;
  return profile;
}

}  // namespace tribolog::render
