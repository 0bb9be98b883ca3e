#pragma once
// The surfaces of a scene's solid parts.

#include <vector>

#include "render/figure/draw_list.h"

namespace tribolog::render::scene {

/// One mesh for each part, the ground first. Parts without a size are left out.
std::vector<figure::SceneMesh> part_meshes(const figure::Scene& scene,
                                           const figure::SceneView& view, double unit_px);

}  // namespace tribolog::render::scene
