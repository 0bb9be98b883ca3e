#include "render/scene/part_meshes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "render/figure/vector3.h"
#include "render/scene/turned_surface.h"

namespace tribolog::render {
namespace {

constexpr double pi = std::numbers::pi;
constexpr Colour grid_colour{214, 214, 214};
constexpr double grid_line_px = 1.6;

/// What is left of a colour on white paper.
Colour on_paper(Colour colour) {
  const auto mixed = [&](std::uint8_t part) {
    const double share = colour.alpha / 255.0;
    return static_cast<std::uint8_t>(std::lround(255.0 + (part - 255.0) * share));
  };
  return {mixed(colour.red), mixed(colour.green), mixed(colour.blue)};
}

SceneMesh start(const std::string& label, Colour colour,
                SceneMesh::Finish finish = SceneMesh::Finish::lit) {
  SceneMesh mesh;
  mesh.label = label;
  mesh.colour = on_paper(colour);
  mesh.finish = finish;
  return mesh;
}

/// A convex, flat area.
void add_fan(SceneMesh& mesh, const std::vector<Point3>& outline, Point3 normal,
             const std::vector<Point3>& spread) {
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
void add_bar(SceneMesh& mesh, const SceneBody& body, Point3 along, Point3 normal) {
  const Point3 side = cross(normal, along);
  const double span = length(body.to - body.from);
  const double seam =
      std::acos(std::clamp((body.from_radius_m - body.to_radius_m) / span, -1.0, 1.0));
  std::vector<Point3> rim;
  std::vector<Point3> outwards;
  constexpr int steps = 32;
  const auto arc = [&](Point3 centre, double radius, double from, double to) {
    for (int i = 0; i <= steps; ++i) {
      const double angle = from + (to - from) * i / steps;
      const Point3 out = std::cos(angle) * along + std::sin(angle) * side;
      rim.push_back(centre + radius * out);
      outwards.push_back(out);
    }
  };
  arc(body.to, body.to_radius_m, -seam, seam);
  arc(body.from, body.from_radius_m, seam, 2 * pi - seam);

  const Point3 half = 0.5 * body.thickness_m * normal;
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
    std::vector<Point3> outline;
    std::vector<Point3> spread;
    for (std::uint32_t i = 0; i < count; ++i) {
      const std::uint32_t k = face > 0 ? i : count - 1 - i;
      outline.push_back(rim[k] + face * half);
      spread.push_back(outwards[k] + face * normal);
    }
    add_fan(mesh, outline, face * normal, spread);
  }
}

SceneMesh mesh_of(const SceneBody& body) {
  SceneMesh mesh = start(body.label, body.colour);
  const Point3 span = body.to - body.from;
  const double size = length(span);
  const Point3 along = size > 0 ? unit(span) : Point3{0, 0, 1};
  const Point3 normal = body.normal - dot(body.normal, along) * along;
  if (body.thickness_m > 0 && size > 0 && length(normal) > 0) {
    add_bar(mesh, body, along, unit(normal));
  } else {
    add_turned_surface(mesh, body.from, along,
                       {round_profile(size, body.from_radius_m, body.to_radius_m)});
  }
  return mesh;
}

SceneMesh mesh_of(const SceneDrum& drum) {
  SceneMesh mesh = start(drum.label, drum.colour);
  const double half = drum.length_m / 2;
  const double chamfer = 0.12 * std::min(drum.radius_m, drum.length_m);
  add_turned_surface(mesh, drum.centre, unit(drum.axis),
                     sharp_profile({{-half, 0},
                                    {-half, drum.radius_m - chamfer},
                                    {-half + chamfer, drum.radius_m},
                                    {half - chamfer, drum.radius_m},
                                    {half, drum.radius_m - chamfer},
                                    {half, 0}}));
  return mesh;
}

SceneMesh mesh_of(const SceneArrow& arrow) {
  SceneMesh mesh = start(arrow.label, arrow.colour);
  const double size = length(arrow.to - arrow.from);
  const double head = std::min(0.45 * size, 7.0 * arrow.radius_m);
  add_turned_surface(mesh, arrow.from, unit(arrow.to - arrow.from),
                     sharp_profile({{0, 0},
                                    {0, arrow.radius_m},
                                    {size - head, arrow.radius_m},
                                    {size - head, 2.6 * arrow.radius_m},
                                    {size, 0}}));
  return mesh;
}

SceneMesh mesh_of(const SceneBall& ball, const SceneView& view) {
  SceneMesh mesh = start(ball.label, ball.colour);
  const double shown_m = ball.inside ? view.front_m() : view.distance(ball.centre);
  const Point3 centre = view.moved_to(ball.centre, shown_m);
  const double radius =
      view.parallel ? ball.radius_m : ball.radius_m * shown_m / view.distance(ball.centre);
  add_turned_surface(mesh, centre, unit(view.up), {round_profile(0, radius, radius)});
  return mesh;
}

/// Behind everything: in its own plane it would cut the parts that lie across it, and their
/// outlines.
SceneMesh mesh_of(const SceneSector& sector, const SceneView& view) {
  SceneMesh mesh = start("", sector.fill, SceneMesh::Finish::flat);
  const Point3 normal = unit(sector.normal);
  constexpr double step_rad = pi / 90;
  const double span = sector.to_rad - sector.from_rad;
  const int steps = std::max(1, static_cast<int>(std::ceil(std::abs(span) / step_rad)));
  std::vector<Point3> outline{sector.centre};
  for (int i = 0; i <= steps; ++i) {
    const double angle = sector.from_rad + span * i / steps;
    outline.push_back(sector.centre + sector.radius_m * turned(unit(sector.zero), normal, angle));
  }
  for (Point3& p : outline) p = view.moved_to(p, view.back_m());
  add_fan(mesh, outline, normal, {});
  return mesh;
}

SceneMesh mesh_of(const SceneGround& ground, const SceneView& view, double line_px) {
  SceneMesh mesh = start("", grid_colour, SceneMesh::Finish::flat);
  const Point3 up{0, 0, 1};
  const int lines = static_cast<int>(std::floor(ground.half_size_m / ground.spacing_m + 1e-9));
  for (int i = -lines; i <= lines; ++i) {
    for (const bool along_x : {true, false}) {
      const Point3 run = along_x ? Point3{1, 0, 0} : Point3{0, 1, 0};
      const Point3 side = along_x ? Point3{0, 1, 0} : Point3{1, 0, 0};
      const Point3 middle = ground.centre + (i * ground.spacing_m) * side;
      const double reach = lines * ground.spacing_m;
      const double half = 0.5 * line_px * view.metres_per_pixel(middle);
      // Seen at a slant, a line across the view would be thinner than one along it.
      const Point3 in_view = side - dot(side, view.forward) * view.forward;
      const double wide = half / std::max(0.2, length(in_view));
      add_fan(mesh,
              {middle - reach * run - wide * side, middle + reach * run - wide * side,
               middle + reach * run + wide * side, middle - reach * run + wide * side},
              up, {});
    }
  }
  return mesh;
}

}  // namespace

std::vector<SceneMesh> part_meshes(const Scene& scene, const SceneView& view, double unit_px) {
  std::vector<SceneMesh> meshes;
  if (scene.ground && scene.ground->spacing_m > 0) {
    meshes.push_back(mesh_of(*scene.ground, view, grid_line_px * unit_px));
  }
  for (const SceneSector& one : scene.sectors) {
    if (one.filled && one.radius_m > 0) meshes.push_back(mesh_of(one, view));
  }
  for (const SceneBody& one : scene.bodies) {
    if (one.from_radius_m > 0 && one.to_radius_m > 0) meshes.push_back(mesh_of(one));
  }
  for (const SceneDrum& one : scene.drums) {
    if (one.radius_m > 0 && one.length_m > 0) meshes.push_back(mesh_of(one));
  }
  for (const SceneArrow& one : scene.arrows) {
    if (length(one.to - one.from) > 0 && one.radius_m > 0) meshes.push_back(mesh_of(one));
  }
  for (const SceneBall& one : scene.balls) {
    if (one.radius_m > 0) meshes.push_back(mesh_of(one, view));
  }
  return meshes;
}

}  // namespace tribolog::render
