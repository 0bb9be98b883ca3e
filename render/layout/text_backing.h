#pragma once
// White, almost opaque ground behind a text that stands on data.

#include "render/figure/draw_list.h"
#include "render/layout/figure_style.h"

namespace tribolog::render {

inline void draw_backing(DrawList& list, const PixelBox& box, int panel, int index) {
  list.primitives.emplace_back(Polygon{
      {Role::text_backing, panel, index},
      {{box.left, box.top}, {box.right, box.top}, {box.right, box.bottom}, {box.left, box.bottom}},
      ink::backing});
}

}  // namespace tribolog::render
