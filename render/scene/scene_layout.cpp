#include "render/scene/scene_layout.h"

#include <stdexcept>
#include <utility>

#include "base/error.h"
#include "render/figure/scene.h"
#include "render/layout/panel_drawing.h"
#include "render/scene/annotations.h"
#include "render/scene/scene_geometry.h"

namespace tribolog::render::scene {
namespace {

void require_direction(figure::Point3 direction, const std::string& label, Code missing) {
  const double size = figure::length(direction);
  if (std::isfinite(size) && size > 0) return;
  throw FigureError(Statement(missing, {{"label", label}}));
}

void check_parts(const figure::Scene& scene) {
  for (const figure::SceneDrum& one : scene.drums)
    require_direction(one.axis, one.label, "drawing.part_without_axis");
  for (const figure::SceneArrow& one : scene.arrows) {
    require_direction(one.to - one.from, one.label, "drawing.part_without_length");
  }
  for (const figure::SceneSector& one : scene.sectors) {
    require_direction(one.normal, one.label, "drawing.part_without_normal");
    require_direction(one.zero, one.label, "drawing.part_without_zero_line");
  }
}

/// In the order in which texts are placed: those that have the least choice first.
std::vector<Caption> captions_of(const figure::Scene& scene, const figure::SceneView& view) {
  std::vector<Caption> captions;
  const auto add = [&](const std::string& text, figure::Point3 at, figure::Colour colour) {
    if (!text.empty()) captions.push_back({text, view.pixel(at), colour});
  };
  for (const figure::SceneDimension& one : scene.dimensions)
    add(one.label, middle_of(one), one.colour);
  for (const figure::SceneSector& one : scene.sectors) add(one.label, middle_of(one), one.colour);
  for (const figure::SceneBall& one : scene.balls) add(one.label, one.centre, one.colour);
  for (const figure::SceneArrow& one : scene.arrows) add(one.label, one.to, one.colour);
  for (const figure::SceneLine& one : scene.lines) add(one.label, middle_of(one), one.colour);
  for (const figure::SceneText& one : scene.texts) add(one.text, one.at, one.colour);
  for (const figure::SceneDrum& one : scene.drums) add(one.label, one.centre, layout::ink::text);
  for (const figure::SceneBody& one : scene.bodies)
    add(one.label, 0.5 * (one.from + one.to), layout::ink::text);
  return captions;
}

/// Texts keep off solid parts and lines, but may stand on the floor and in a filled sector.
Obstacles obstacles_of(const figure::DrawList& list, const figure::PixelBox& room) {
  Obstacles taken{layout::Occupancy(room), layout::Occupancy(room)};
  if (!list.scene) return taken;
  const std::vector<figure::SceneMesh>& meshes = list.scene->meshes;
  const PartMap parts(*list.scene, list.width, list.height);
  constexpr int step = static_cast<int>(layout::Occupancy::cell_px);
  for (int y = 0; y < list.height; y += step) {
    for (int x = 0; x < list.width; x += step) {
      const std::uint16_t part = parts.at(x, y);
      if (part == 0 || meshes[part - 1U].finish == figure::SceneMesh::Finish::flat) continue;
      taken.solid.mark(figure::PixelBox{x + 0.0, y + 0.0, x + 1.0, y + 1.0});
    }
  }
  for (const figure::Primitive& primitive : list.primitives) {
    if (figure::owner_of(primitive).role == figure::Role::scene_line) taken.lines.mark(primitive);
  }
  return taken;
}

}  // namespace

figure::DrawList lay_out_scene(const figure::Figure& figure, const text::Font& font,
                               text::TextFaults& faults) {
  if (!figure.scene) throw std::logic_error("no scene");
  const figure::Scene& scene = *figure.scene;
  const layout::FigureStyle style(figure);
  figure::DrawList list;
  list.width = figure.width_px;
  list.height = figure.height_px;
  list.width_mm = figure.width_mm;
  check_parts(scene);

  layout::FigureFrame frame;
  bool cut = false;
  const double width = figure.width_px - 2 * style.margin;
  frame.title = text::wrap_lines(font, figure.title, style.figure_title, width, 3, faults, cut);
  if (cut) list.warnings.push_back({"drawing.title_cut", {{"title", figure.title}}});
  const double title_height =
      1.28 * style.figure_title.size_px * static_cast<double>(frame.title.size());
  const figure::PixelBox room{style.margin, style.margin + title_height + style.gap,
                              figure.width_px - style.margin, figure.height_px - style.margin};
  const double free_x = scene.camera.margin * room.width();
  const double free_y = scene.camera.margin * room.height();
  std::vector<Sphere> shown;
  for (const figure::Point3& p : scene.camera.fit) shown.push_back({p, 0.0});
  if (shown.empty()) shown = reach_of(scene);
  if (shown.empty()) throw FigureError({"drawing.empty_scene"});

  figure::SceneGeometry geometry;
  geometry.view =
      fit_view(scene.camera, shown,
               {room.left + free_x, room.top + free_y, room.right - free_x, room.bottom - free_y});
  geometry.meshes = part_meshes(scene, geometry.view, style.unit);
  list.scene = std::move(geometry);
  draw_annotations(list, scene, list.scene->view, style);
  const Obstacles taken = obstacles_of(list, room);
  draw_captions(list, captions_of(scene, list.scene->view), room, taken, font, style, faults);
  layout::draw_figure_title(list, frame, style);
  return list;
}

}  // namespace tribolog::render::scene
