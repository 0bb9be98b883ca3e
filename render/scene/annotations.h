#pragma once
// Lines, arcs and dimensions of a scene, drawn over its solid parts.

#include "render/figure/draw_list.h"
#include "render/layout/figure_style.h"

namespace tribolog::render {

/// Sectors' arcs, dimensions and lines, each with Role::scene_line and its place in the order of
/// annotation_labels().
void draw_annotations(DrawList& list, const Scene& scene, const SceneView& view,
                      const FigureStyle& style);

/// The label of each annotation, by index.
std::vector<std::string> annotation_labels(const Scene& scene);

/// Where the label of an arc or of a dimension belongs.
Point3 middle_of(const SceneSector& sector);
Point3 middle_of(const SceneDimension& dimension);
Point3 middle_of(const SceneLine& line);

}  // namespace tribolog::render
