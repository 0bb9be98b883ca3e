#include "render/layout/polyline.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace tribolog::render::layout {

namespace {

constexpr double column_width = simplification_tolerance_px;
constexpr double noise_travel = 2.0;  // times the reach; a line that just passes travels it once
constexpr double sector_tolerance = 0.1;  // finer than promised: bends of smooth curves show

/// Up and down added up.
double travel(const std::vector<figure::PixelPoint>& points) {
  double sum = 0;
  for (std::size_t i = 1; i < points.size(); ++i) sum += std::abs(points[i].y - points[i - 1].y);
  return sum;
}

double cross(figure::PixelPoint a, figure::PixelPoint b) { return a.x * b.y - a.y * b.x; }
double dot(figure::PixelPoint a, figure::PixelPoint b) { return a.x * b.x + a.y * b.y; }

}  // namespace

void PolylineSimplifier::add(figure::PixelPoint point) {
  const double column = std::floor(point.x / column_width);
  if (column != column_) flush_column(false);
  column_ = column;
  in_this_column_.push_back(point);
}

void PolylineSimplifier::flush_column(bool line_ends) {
  if (in_this_column_.empty()) return;
  const std::vector<figure::PixelPoint>& points = in_this_column_;
  const auto move_to = [this](figure::PixelPoint to) {
    if (has_pen_ && to == pen_) return;
    add_to_sector(to);
    pen_ = to;
    has_pen_ = true;
  };
  const auto [lowest, highest] = std::minmax_element(
      points.begin(), points.end(),
      [](const figure::PixelPoint& a, const figure::PixelPoint& b) { return a.y < b.y; });
  if (travel(points) <= noise_travel * (highest->y - lowest->y)) {
    for (const figure::PixelPoint& point : points) move_to(point);
  } else {
    // Entering at the nearer end lets each column be drawn in a single stroke.
    if (!has_pen_) move_to(points.front());
    const bool down = std::abs(lowest->y - pen_.y) <= std::abs(highest->y - pen_.y);
    move_to(down ? *lowest : *highest);
    move_to(down ? *highest : *lowest);
    if (line_ends) move_to(points.back());
  }
  in_this_column_.clear();
}

void PolylineSimplifier::restart_sector(figure::PixelPoint anchor) {
  kept_.push_back(anchor);
  has_candidate_ = false;
  open_ = true;
  reach_ = 0;
}

void PolylineSimplifier::add_to_sector(figure::PixelPoint point) {
  if (kept_.empty()) {
    restart_sector(point);
    return;
  }
  const figure::PixelPoint anchor = kept_.back();
  figure::PixelPoint step{point.x - anchor.x, point.y - anchor.y};
  double distance = std::hypot(step.x, step.y);
  const bool turned_back = has_candidate_ && distance < reach_;
  const bool outside = !open_ && distance > sector_tolerance &&
                       (cross(bound_right_, step) < 0 || cross(bound_left_, step) > 0 ||
                        dot(bound_right_, step) < 0);
  if (turned_back || outside) {
    restart_sector(candidate_);
    step = {point.x - candidate_.x, point.y - candidate_.y};
    distance = std::hypot(step.x, step.y);
  }
  candidate_ = point;
  has_candidate_ = true;
  reach_ = distance;
  if (distance <= sector_tolerance) return;
  const double angle = std::asin(sector_tolerance / distance);
  const double cosine = std::cos(angle);
  const double sine = std::sin(angle);
  const figure::PixelPoint left{step.x * cosine - step.y * sine, step.x * sine + step.y * cosine};
  const figure::PixelPoint right{step.x * cosine + step.y * sine, -step.x * sine + step.y * cosine};
  if (open_ || cross(bound_left_, left) < 0) bound_left_ = left;
  if (open_ || cross(bound_right_, right) > 0) bound_right_ = right;
  open_ = false;
}

std::vector<figure::PixelPoint> PolylineSimplifier::take() {
  flush_column(true);
  has_pen_ = false;
  if (has_candidate_) kept_.push_back(candidate_);
  has_candidate_ = false;
  open_ = true;
  reach_ = 0;
  return std::exchange(kept_, {});
}

std::vector<figure::PixelPoint> simplified(const std::vector<figure::PixelPoint>& line) {
  PolylineSimplifier simplifier;
  for (const figure::PixelPoint& point : line) simplifier.add(point);
  return simplifier.take();
}

std::optional<PixelSegment> clipped(const PixelSegment& segment, const figure::PixelBox& box) {
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
    return figure::PixelPoint{std::clamp(a.x + t * dx, box.left, box.right),
                              std::clamp(a.y + t * dy, box.top, box.bottom)};
  };
  return PixelSegment{enters == 0.0 ? a : at(enters), leaves == 1.0 ? b : at(leaves)};
}

void LineCollector::add(figure::PixelPoint point) {
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

std::vector<std::vector<figure::PixelPoint>> LineCollector::take() {
  lift();
  return std::move(lines_);
}

namespace {

double distance(figure::PixelPoint p, figure::PixelPoint a, figure::PixelPoint b) {
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  const double square = dx * dx + dy * dy;
  const double share =
      square > 0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / square, 0.0, 1.0) : 0.0;
  return std::hypot(p.x - a.x - share * dx, p.y - a.y - share * dy);
}

}  // namespace

bool lies_on(const std::vector<figure::PixelPoint>& line, figure::PixelPoint p, double reach) {
  for (std::size_t i = 1; i < line.size(); ++i) {
    if (distance(p, line[i - 1], line[i]) <= reach) return true;
  }
  return false;
}

// Liang and Barsky's clipping.
bool enters(const std::vector<figure::PixelPoint>& line, const figure::PixelBox& box) {
  for (std::size_t i = 1; i < line.size(); ++i) {
    const figure::PixelPoint& a = line[i - 1];
    const double dx = line[i].x - a.x;
    const double dy = line[i].y - a.y;
    double from = 0;
    double to = 1;
    const auto clip = [&](double slope, double room) {
      if (std::abs(slope) < 1e-12) {
        if (room <= 0) to = -1;
      } else if (slope > 0) {
        to = std::min(to, room / slope);
      } else {
        from = std::max(from, room / slope);
      }
    };
    clip(-dx, a.x - box.left);
    clip(dx, box.right - a.x);
    clip(-dy, a.y - box.top);
    clip(dy, box.bottom - a.y);
    if (from < to) return true;
  }
  return false;
}

}  // namespace tribolog::render::layout
