#include "render/figure/draw_list.h"

#include "render/figure/scene.h"

namespace tribolog::render::figure {

double SceneView::distance(Point3 p) const { return dot(p - eye, forward); }

PixelPoint SceneView::pixel(Point3 p) const {
  const double k = parallel ? scale : scale / distance(p);
  return {origin.x + k * dot(p - eye, right), origin.y - k * dot(p - eye, up)};
}

double SceneView::metres_per_pixel(Point3 p) const {
  return (parallel ? 1.0 : distance(p)) / scale;
}

Point3 SceneView::moved_to(Point3 p, double distance_m) const {
  if (parallel) return p + (distance_m - distance(p)) * forward;
  return eye + (distance_m / distance(p)) * (p - eye);
}

std::array<double, 16> SceneView::clip_matrix(int width, int top, int rows) const {
  const double kx = 2 * scale / width;
  const double ky = 2 * scale / rows;
  const double dx = 2 * origin.x / width - 1;
  const double dy = 1 - 2 * (origin.y - top) / rows;
  const double n = 0.25 * nearest_m;
  const double f = 1.05 * farthest_m;
  if (parallel) {
    return {kx,
            0,
            0,
            dx,  //
            0,
            ky,
            0,
            dy,  //
            0,
            0,
            -2 / (f - n),
            -(f + n) / (f - n),  //
            0,
            0,
            0,
            1};
  }
  return {kx,
          0,
          -dx,
          0,  //
          0,
          ky,
          -dy,
          0,  //
          0,
          0,
          -(f + n) / (f - n),
          -2 * f * n / (f - n),  //
          0,
          0,
          -1,
          0};
}

}  // namespace tribolog::render::figure
