#include "render/layout/discrete_marks.h"

#include <algorithm>

namespace tribolog::render {
namespace {

constexpr std::size_t cloud = 150;  // markers
constexpr double core = 0.8;        // of a marker's size: texts may come close

PixelBox box_of(PixelPoint a, PixelPoint b) {
  return {std::min(a.x, b.x), std::min(a.y, b.y), std::max(a.x, b.x), std::max(a.y, b.y)};
}

}  // namespace

void DiscreteMarks::add(const Primitive& primitive) {
  const Role role = owner_of(primitive).role;
  const auto* markers = std::get_if<Markers>(&primitive);
  if (markers != nullptr && role == Role::series_marker && markers->centres.size() < cloud) {
    for (const PixelPoint& c : markers->centres) {
      add(box_of(c, c).grown(core * markers->size / 2));
    }
  }
  const auto* line = std::get_if<Polyline>(&primitive);
  if (line != nullptr && role == Role::error_bar) {
    add(box_of(line->points.front(), line->points.back()).grown(line->width / 2));
  }
}

bool DiscreteMarks::touched_by(const PixelBox& box) const {
  return std::any_of(boxes_.begin(), boxes_.end(),
                     [&](const PixelBox& one) { return overlap_area(one, box) > 0; });
}

}  // namespace tribolog::render
