#include "render/layout/clip.h"

#include <algorithm>

namespace tribolog::render {

std::optional<PixelSegment> clipped(const PixelSegment& segment, const PixelBox& box) {
  const auto [a, b] = segment;
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  double enters = 0.0;
  double leaves = 1.0;
  const auto cut = [&](double direction, double room) {
    if (direction == 0.0) return room >= 0.0;
    const double at = room / direction;
    if (direction < 0.0) {
      enters = std::max(enters, at);
    } else {
      leaves = std::min(leaves, at);
    }
    return enters <= leaves;
  };
  if (!cut(-dx, a.x - box.left) || !cut(dx, box.right - a.x) || !cut(-dy, a.y - box.top) ||
      !cut(dy, box.bottom - a.y)) {
    return std::nullopt;
  }
  const auto at = [&, &a = a](double t) {
    return PixelPoint{std::clamp(a.x + t * dx, box.left, box.right),
                      std::clamp(a.y + t * dy, box.top, box.bottom)};
  };
  return PixelSegment{enters == 0.0 ? a : at(enters), leaves == 1.0 ? b : at(leaves)};
}

void LineCollector::add(PixelPoint point) {
  if (!has_previous_) {
    has_previous_ = true;
    previous_ = point;
    if (box_.contains(point)) {
      simplifier_.add(point);
      drawing_ = true;
    }
    return;
  }
  const auto visible = clipped({previous_, point}, box_);
  if (visible) {
    if (!drawing_) simplifier_.add(visible->first);
    simplifier_.add(visible->second);
    drawing_ = true;
  }
  if (drawing_ && !box_.contains(point)) end_line();
  previous_ = point;
}

void LineCollector::end_line() {
  if (!drawing_) return;
  drawing_ = false;
  lines_.push_back(simplifier_.take());
}

void LineCollector::lift() {
  end_line();
  has_previous_ = false;
}

std::vector<std::vector<PixelPoint>> LineCollector::take() {
  lift();
  return std::move(lines_);
}

}  // namespace tribolog::render
