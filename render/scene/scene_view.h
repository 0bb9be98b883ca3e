#pragma once
// Fits a camera to what it has to show.

#include <vector>

#include "render/figure/draw_list.h"

namespace tribolog::render::scene {

struct Sphere {
  figure::Point3 centre;
  double radius_m{};
};

/// What the parts of a scene reach; labels are not counted.
std::vector<Sphere> reach_of(const figure::Scene& scene);

/// The view in which all of `shown` (not empty) fits into `room` as large as it can, centred.
/// @throw tribolog::FigureError for a camera without direction, with `up` along it, or with an
/// opening or margin outside its range; for a scene that has no size or is not finite.
figure::SceneView fit_view(const figure::SceneCamera& camera, const std::vector<Sphere>& shown,
                           const figure::PixelBox& room);

}  // namespace tribolog::render::scene
