#pragma once
// What is drawn over the solid parts of a scene: lines, arcs and dimensions, and texts near the
// points that they name.

#include <string>
#include <vector>

#include "render/figure/draw_list.h"
#include "render/layout/figure_style.h"
#include "render/layout/occupancy.h"

namespace tribolog::render::scene {

/// Sectors' arcs, dimensions and lines, each with Role::scene_line and its place in the order of
/// annotation_labels().
void draw_annotations(figure::DrawList& list, const figure::Scene& scene,
                      const figure::SceneView& view, const layout::FigureStyle& style);

/// The label of each annotation, by index.
std::vector<std::string> annotation_labels(const figure::Scene& scene);

/// Where the label of an arc or of a dimension belongs.
figure::Point3 middle_of(const figure::SceneSector& sector);
figure::Point3 middle_of(const figure::SceneDimension& dimension);
figure::Point3 middle_of(const figure::SceneLine& line);

struct Caption {
  std::string text;
  figure::PixelPoint anchor;
  figure::Colour colour;
};

/// What texts keep off.
struct Obstacles {
  layout::Occupancy solid;  ///< Parts of the scene.
  layout::Occupancy lines;  ///< Arcs, dimensions and lines.
};

/// Places the captions inside `room`, on as few obstacles as can be, off each other and off each
/// other's leader lines, and draws them with a white halo; one that ends up away from its
/// anchor gets a leader. What still collides, or is cut, is said in the list's warnings.
void draw_captions(figure::DrawList& list, const std::vector<Caption>& captions,
                   const figure::PixelBox& room, const Obstacles& obstacles, const text::Font& font,
                   const layout::FigureStyle& style, text::TextFaults& faults);

}  // namespace tribolog::render::scene
