#pragma once
// The geometry of a scene: the camera that shows it, the surfaces of its parts, and which of them
// is to be seen at each pixel.

#include <cstddef>
#include <cstdint>
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

/// One mesh for each part, the ground first. Parts without a size are left out.
std::vector<figure::SceneMesh> part_meshes(const figure::Scene& scene,
                                           const figure::SceneView& view, double unit_px);

/// Which part of a scene is to be seen at each pixel, worked out without any graphics.
class PartMap {
 public:
  PartMap(const figure::SceneGeometry& scene, int width, int height);

  /// Index into SceneGeometry::meshes plus one, or 0 where the paper is blank.
  [[nodiscard]] std::uint16_t at(int x, int y) const {
    return parts_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                  static_cast<std::size_t>(x)];
  }
  /// Whether the part covers the pixel and all its neighbours, so that no edge is near.
  [[nodiscard]] bool inside(int x, int y, int reach) const;
  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }

 private:
  struct Corner {
    double x, y, nearness;
  };
  void fill(const Corner& a, const Corner& b, const Corner& c, std::uint16_t part);

  int width_;
  int height_;
  std::vector<std::uint16_t> parts_;
  std::vector<float> nearness_;
};

}  // namespace tribolog::render::scene
