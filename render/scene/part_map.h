#pragma once
// Which part of a scene is to be seen at each pixel, worked out without any graphics.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "render/figure/draw_list.h"

namespace tribolog::render::scene {

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
