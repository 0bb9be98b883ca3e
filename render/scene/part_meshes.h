#pragma once
// The surfaces of a scene's solid parts.

#include <vector>

#include "render/figure/draw_list.h"

namespace tribolog::render {

/// One mesh for each part, the ground first. Parts without a size are left out.
std::vector<SceneMesh> part_meshes(const Scene& scene, const SceneView& view, double unit_px);

}  // namespace tribolog::render
