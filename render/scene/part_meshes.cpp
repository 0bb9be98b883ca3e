#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "render/figure/draw_list.h"
#include "render/figure/scene.h"
#include "render/scene/scene_geometry.h"

namespace tribolog::render::scene {

// Surfaces of revolution, of which drums, arrows, balls and round links are made.

namespace {

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

constexpr int segments = 64;   // about the axis
constexpr int cap_steps = 12;  // of a round end, from its pole on
constexpr double pi = std::numbers::pi;

/// Adds the surface about the axis from `origin` in the direction `axis` (a unit vector). Pieces
/// run from back to front along the axis.
void add_turned_surface(figure::SceneMesh& mesh, figure::Point3 origin, figure::Point3 axis,
                        const std::vector<ProfilePiece>& pieces) {
  const figure::Point3 across = figure::any_across(axis);
  const figure::Point3 third = figure::cross(axis, across);
  for (const ProfilePiece& piece : pieces) {
    const auto first = static_cast<std::uint32_t>(mesh.points.size());
    for (const ProfilePoint& p : piece) {
      for (int i = 0; i < segments; ++i) {
        const double angle = 2 * pi * i / segments;
        const figure::Point3 out = std::cos(angle) * across + std::sin(angle) * third;
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

/// Straight pieces with sharp edges through (along, away) corners.
std::vector<ProfilePiece> sharp_profile(const std::vector<figure::PixelPoint>& corners) {
  std::vector<figure::PixelPoint> normals;
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
      const figure::PixelPoint n = normals[i];
      figure::PixelPoint spread = n;
      if (corners[end].y == 0) {
        // All points of a tip must move alike, or the outline gapes there.
        constexpr double farthest = 3.0;
        const double out = std::min(farthest, 1.0 / std::max(1e-9, std::abs(n.x)));
        spread = {std::copysign(out, n.x), 0.0};
      }
      const bool has_neighbour = end > 0 && end < normals.size();
      if (has_neighbour) {
        const figure::PixelPoint other = normals[end == i ? i - 1 : i + 1];
        const double share = 1.0 / std::max(0.5, 1.0 + n.x * other.x + n.y * other.y);
        spread = {(n.x + other.x) * share, (n.y + other.y) * share};
      }
      piece.push_back({corners[end].x, corners[end].y, n.x, n.y, spread.x, spread.y});
    }
    pieces.push_back(std::move(piece));
  }
  return pieces;
}

/// The convex hull of two spheres on the axis, at 0 and at `distance`.
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

constexpr figure::Colour grid_colour{214, 214, 214};
constexpr double grid_line_px = 1.6;

/// What is left of a colour on white paper.
figure::Colour on_paper(figure::Colour colour) {
  const auto mixed = [&](std::uint8_t part) {
    const double share = colour.alpha / 255.0;
    return static_cast<std::uint8_t>(std::lround(255.0 + (part - 255.0) * share));
  };
  return {mixed(colour.red), mixed(colour.green), mixed(colour.blue)};
}

figure::SceneMesh start(const std::string& label, figure::Colour colour,
                        figure::SceneMesh::Finish finish = figure::SceneMesh::Finish::lit) {
  figure::SceneMesh mesh;
  mesh.label = label;
  mesh.colour = on_paper(colour);
  mesh.finish = finish;
  return mesh;
}

/// A convex, flat area.
void add_fan(figure::SceneMesh& mesh, const std::vector<figure::Point3>& outline,
             figure::Point3 normal, const std::vector<figure::Point3>& spread) {
  const auto first = static_cast<std::uint32_t>(mesh.points.size());
  for (std::size_t i = 0; i < outline.size(); ++i) {
    mesh.points.push_back(outline[i]);
    mesh.normals.push_back(normal);
    mesh.spread.push_back(spread.empty() ? normal : spread[i]);
  }
  for (std::uint32_t i = 1; i + 1 < outline.size(); ++i) {
    mesh.triangles.push_back({first, first + i, first + i + 1});
  }
}

/// The hull of two circles, as thick as the bar.
void add_bar(figure::SceneMesh& mesh, const figure::SceneBody& body, figure::Point3 along,
             figure::Point3 normal) {
  const figure::Point3 side = figure::cross(normal, along);
  const double span = figure::length(body.to - body.from);
  const double seam =
      std::acos(std::clamp((body.from_radius_m - body.to_radius_m) / span, -1.0, 1.0));
  std::vector<figure::Point3> rim;
  std::vector<figure::Point3> outwards;
  constexpr int steps = 32;
  const auto arc = [&](figure::Point3 centre, double radius, double from, double to) {
    for (int i = 0; i <= steps; ++i) {
      const double angle = from + (to - from) * i / steps;
      const figure::Point3 out = std::cos(angle) * along + std::sin(angle) * side;
      rim.push_back(centre + radius * out);
      outwards.push_back(out);
    }
  };
  arc(body.to, body.to_radius_m, -seam, seam);
  arc(body.from, body.from_radius_m, seam, 2 * pi - seam);

  const figure::Point3 half = 0.5 * body.thickness_m * normal;
  const auto first = static_cast<std::uint32_t>(mesh.points.size());
  const auto count = static_cast<std::uint32_t>(rim.size());
  for (std::uint32_t i = 0; i < count; ++i) {
    for (const double face : {-1.0, 1.0}) {
      mesh.points.push_back(rim[i] + face * half);
      mesh.normals.push_back(outwards[i]);
      mesh.spread.push_back(outwards[i] + face * normal);
    }
    const std::uint32_t a = first + 2 * i;
    const std::uint32_t b = first + 2 * ((i + 1) % count);
    mesh.triangles.push_back({a, b, a + 1});
    mesh.triangles.push_back({b, b + 1, a + 1});
  }
  for (const double face : {1.0, -1.0}) {
    std::vector<figure::Point3> outline;
    std::vector<figure::Point3> spread;
    for (std::uint32_t i = 0; i < count; ++i) {
      const std::uint32_t k = face > 0 ? i : count - 1 - i;
      outline.push_back(rim[k] + face * half);
      spread.push_back(outwards[k] + face * normal);
    }
    add_fan(mesh, outline, face * normal, spread);
  }
}

figure::SceneMesh mesh_of(const figure::SceneBody& body) {
  figure::SceneMesh mesh = start(body.label, body.colour);
  const figure::Point3 span = body.to - body.from;
  const double size = figure::length(span);
  const figure::Point3 along = size > 0 ? figure::unit(span) : figure::Point3{0, 0, 1};
  const figure::Point3 normal = body.normal - figure::dot(body.normal, along) * along;
  if (body.thickness_m > 0 && size > 0 && figure::length(normal) > 0) {
    add_bar(mesh, body, along, figure::unit(normal));
  } else {
    add_turned_surface(mesh, body.from, along,
                       {round_profile(size, body.from_radius_m, body.to_radius_m)});
  }
  return mesh;
}

figure::SceneMesh mesh_of(const figure::SceneDrum& drum) {
  figure::SceneMesh mesh = start(drum.label, drum.colour);
  const double half = drum.length_m / 2;
  const double chamfer = 0.12 * std::min(drum.radius_m, drum.length_m);
  add_turned_surface(mesh, drum.centre, figure::unit(drum.axis),
                     sharp_profile({{-half, 0},
                                    {-half, drum.radius_m - chamfer},
                                    {-half + chamfer, drum.radius_m},
                                    {half - chamfer, drum.radius_m},
                                    {half, drum.radius_m - chamfer},
                                    {half, 0}}));
  return mesh;
}

figure::SceneMesh mesh_of(const figure::SceneArrow& arrow) {
  figure::SceneMesh mesh = start(arrow.label, arrow.colour);
  const double size = figure::length(arrow.to - arrow.from);
  const double head = std::min(0.45 * size, 7.0 * arrow.radius_m);
  add_turned_surface(mesh, arrow.from, figure::unit(arrow.to - arrow.from),
                     sharp_profile({{0, 0},
                                    {0, arrow.radius_m},
                                    {size - head, arrow.radius_m},
                                    {size - head, 2.6 * arrow.radius_m},
                                    {size, 0}}));
  return mesh;
}

figure::SceneMesh mesh_of(const figure::SceneBall& ball, const figure::SceneView& view) {
  figure::SceneMesh mesh = start(ball.label, ball.colour);
  const double shown_m = ball.inside ? view.front_m() : view.distance(ball.centre);
  const figure::Point3 centre = view.moved_to(ball.centre, shown_m);
  const double radius =
      view.parallel ? ball.radius_m : ball.radius_m * shown_m / view.distance(ball.centre);
  add_turned_surface(mesh, centre, figure::unit(view.up), {round_profile(0, radius, radius)});
  return mesh;
}

/// Behind everything: in its own plane it would cut the parts that lie across it, and their
/// outlines.
figure::SceneMesh mesh_of(const figure::SceneSector& sector, const figure::SceneView& view) {
  figure::SceneMesh mesh = start("", sector.fill, figure::SceneMesh::Finish::flat);
  const figure::Point3 normal = figure::unit(sector.normal);
  constexpr double step_rad = pi / 90;
  const double span = sector.to_rad - sector.from_rad;
  const int steps = std::max(1, static_cast<int>(std::ceil(std::abs(span) / step_rad)));
  std::vector<figure::Point3> outline{sector.centre};
  for (int i = 0; i <= steps; ++i) {
    const double angle = sector.from_rad + span * i / steps;
    outline.push_back(sector.centre +
                      sector.radius_m * figure::turned(figure::unit(sector.zero), normal, angle));
  }
  for (figure::Point3& p : outline) p = view.moved_to(p, view.back_m());
  add_fan(mesh, outline, normal, {});
  return mesh;
}

figure::SceneMesh mesh_of(const figure::SceneGround& ground, const figure::SceneView& view,
                          double line_px) {
  figure::SceneMesh mesh = start("", grid_colour, figure::SceneMesh::Finish::flat);
  const figure::Point3 up{0, 0, 1};
  const int lines = static_cast<int>(std::floor(ground.half_size_m / ground.spacing_m + 1e-9));
  for (int i = -lines; i <= lines; ++i) {
    for (const bool along_x : {true, false}) {
      const figure::Point3 run = along_x ? figure::Point3{1, 0, 0} : figure::Point3{0, 1, 0};
      const figure::Point3 side = along_x ? figure::Point3{0, 1, 0} : figure::Point3{1, 0, 0};
      const figure::Point3 middle = ground.centre + (i * ground.spacing_m) * side;
      const double reach = lines * ground.spacing_m;
      const double half = 0.5 * line_px * view.metres_per_pixel(middle);
      // Seen at a slant, a line across the view would be thinner than one along it.
      const figure::Point3 in_view = side - figure::dot(side, view.forward) * view.forward;
      const double wide = half / std::max(0.2, figure::length(in_view));
      add_fan(mesh,
              {middle - reach * run - wide * side, middle + reach * run - wide * side,
               middle + reach * run + wide * side, middle - reach * run + wide * side},
              up, {});
    }
  }
  return mesh;
}

}  // namespace

std::vector<figure::SceneMesh> part_meshes(const figure::Scene& scene,
                                           const figure::SceneView& view, double unit_px) {
  std::vector<figure::SceneMesh> meshes;
  if (scene.ground && scene.ground->spacing_m > 0) {
    meshes.push_back(mesh_of(*scene.ground, view, grid_line_px * unit_px));
  }
  for (const figure::SceneSector& one : scene.sectors) {
    if (one.filled && one.radius_m > 0) meshes.push_back(mesh_of(one, view));
  }
  for (const figure::SceneBody& one : scene.bodies) {
    if (one.from_radius_m > 0 && one.to_radius_m > 0) meshes.push_back(mesh_of(one));
  }
  for (const figure::SceneDrum& one : scene.drums) {
    if (one.radius_m > 0 && one.length_m > 0) meshes.push_back(mesh_of(one));
  }
  for (const figure::SceneArrow& one : scene.arrows) {
    if (figure::length(one.to - one.from) > 0 && one.radius_m > 0) meshes.push_back(mesh_of(one));
  }
  for (const figure::SceneBall& one : scene.balls) {
    if (one.radius_m > 0) meshes.push_back(mesh_of(one, view));
  }
  return meshes;
}

}  // namespace tribolog::render::scene
