#pragma once
// Lines, arcs and dimensions of a scene, drawn over its solid parts.

#include "render/figure/draw_list.h"
#include "render/layout/figure_style.h"

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

}  // namespace tribolog::render::scene
