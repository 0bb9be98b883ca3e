#include "render/layout/block_drawing.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tribolog::render {
namespace {

constexpr int circle_corners = 72;
constexpr double frame_line_px = 2.0;
constexpr double hatch_pitch_mm = 2.0;
constexpr double hatch_line_px = 2.0;

/// Points of an arc around `c`, angles in quarter turns.
void add_arc(std::vector<PixelPoint>& out, PixelPoint c, double radius, double from, double to) {
  const int steps = std::max(2, static_cast<int>(std::abs(to - from) * circle_corners / 4));
  for (int i = 0; i <= steps; ++i) {
    const double angle = (from + (to - from) * i / steps) * std::numbers::pi / 2;
    out.push_back({c.x + radius * std::cos(angle), c.y + radius * std::sin(angle)});
  }
}

std::vector<PixelPoint> rounded(const PixelBox& box) {
  const double radius = std::min(box.width(), box.height()) / 2;
  std::vector<PixelPoint> out;
  add_arc(out, {box.right - radius, box.bottom - radius}, radius, 0, 1);
  add_arc(out, {box.left + radius, box.bottom - radius}, radius, 1, 2);
  add_arc(out, {box.left + radius, box.top + radius}, radius, 2, 3);
  add_arc(out, {box.right - radius, box.top + radius}, radius, 3, 4);
  out.push_back(out.front());
  return out;
}

std::vector<PixelPoint> triangle(const PixelBox& box, BlockSide tip) {
  const PixelPoint c = box.centre();
  switch (tip) {
    case BlockSide::left:
      return {{box.left, c.y}, {box.right, box.top}, {box.right, box.bottom}, {box.left, c.y}};
    case BlockSide::top:
      return {{c.x, box.top}, {box.right, box.bottom}, {box.left, box.bottom}, {c.x, box.top}};
    case BlockSide::bottom:
      return {{c.x, box.bottom}, {box.left, box.top}, {box.right, box.top}, {c.x, box.bottom}};
    case BlockSide::right:
      break;
  }
  return {{box.right, c.y}, {box.left, box.bottom}, {box.left, box.top}, {box.right, c.y}};
}

std::vector<PixelPoint> rectangle(const PixelBox& box) {
  return {{box.left, box.top},
          {box.right, box.top},
          {box.right, box.bottom},
          {box.left, box.bottom},
          {box.left, box.top}};
}

std::vector<PixelPoint> surface(const PixelBox& box, BlockSide side) {
  switch (side) {
    case BlockSide::left:
      return {{box.left, box.top}, {box.left, box.bottom}};
    case BlockSide::right:
      return {{box.right, box.top}, {box.right, box.bottom}};
    case BlockSide::bottom:
      return {{box.left, box.bottom}, {box.right, box.bottom}};
    case BlockSide::top:
      break;
  }
  return {{box.left, box.top}, {box.right, box.top}};
}

/// Slanted lines from the surface through the depth of the box.
void draw_hatching(DiagramCanvas& canvas, const Block& block, const PixelBox& box, Owner owner) {
  const bool level = block.faces == BlockSide::top || block.faces == BlockSide::bottom;
  const double run = level ? box.width() : box.height();
  const double depth = level ? box.height() : box.width();
  const int count = std::max(1, static_cast<int>((run - depth) / canvas.length(hatch_pitch_mm)));
  for (int i = 0; i <= count; ++i) {
    const double along = depth + (run - depth) * i / count;
    PixelPoint from;
    PixelPoint to;
    if (level) {
      const bool up = block.faces == BlockSide::top;
      from = {box.left + along, up ? box.top : box.bottom};
      to = {from.x - depth, up ? box.bottom : box.top};
    } else {
      const bool at_left = block.faces == BlockSide::left;
      from = {at_left ? box.left : box.right, box.top + along};
      to = {at_left ? box.right : box.left, from.y - depth};
    }
    canvas.line(owner, {from, to}, hatch_line_px, block.colour);
  }
}

void draw_switch(DiagramCanvas& canvas, const Block& block, const PixelBox& box, Owner owner) {
  const double ahead = block.faces == BlockSide::left ? -1.0 : 1.0;
  const PixelPoint c = box.centre();
  const double x = 0.24 * box.width() * ahead;
  const double y = 0.25 * box.height();
  const double edge = 0.5 * box.width() * ahead;
  canvas.line(owner, {{c.x - edge, c.y - y}, {c.x - x, c.y - y}, {c.x + x, c.y}, {c.x + edge, c.y}},
              diagram_line_px, block.colour);
  canvas.line(owner, {{c.x - edge, c.y + y}, {c.x - x, c.y + y}}, diagram_line_px, block.colour);
  for (const PixelPoint& at :
       {PixelPoint{c.x - x, c.y - y}, PixelPoint{c.x - x, c.y + y}, PixelPoint{c.x + x, c.y}}) {
    std::vector<PixelPoint> dot;
    add_arc(dot, at, canvas.length(0.55), 0, 4);
    canvas.filled(owner, std::move(dot), block.colour);
  }
}

}  // namespace

std::vector<PixelPoint> block_outline(const DiagramCanvas& canvas, const Block& block) {
  const PixelBox box = canvas.box(block.centre, block.width, block.height);
  switch (block.kind) {
    case BlockKind::gain:
      return triangle(box, block.faces);
    case BlockKind::summing_junction: {
      std::vector<PixelPoint> circle;
      add_arc(circle, box.centre(), box.width() / 2, 0, 4);
      circle.back() = circle.front();
      return circle;
    }
    case BlockKind::terminal:
      return rounded(box);
    case BlockKind::fixed_support:
      return surface(box, block.faces);
    default:
      return rectangle(box);
  }
}

void draw_block_fill(DiagramCanvas& canvas, const Block& block, int index) {
  if (block.kind == BlockKind::fixed_support || block.fill.alpha == 0) return;
  std::vector<PixelPoint> outline = block_outline(canvas, block);
  outline.pop_back();
  canvas.filled({Role::block_fill, 0, index}, std::move(outline), block.fill);
}

void draw_block(DiagramCanvas& canvas, const Block& block, int index) {
  const Owner owner{Role::block, 0, index};
  const PixelBox box = canvas.box(block.centre, block.width, block.height);
  const bool frame = block.kind == BlockKind::frame;
  std::vector<PixelPoint> outline = block_outline(canvas, block);
  // Once more along the first side, so that the closing corner is joined like the others.
  if (block.kind != BlockKind::fixed_support && !frame) outline.push_back(outline[1]);
  canvas.line(owner, std::move(outline), frame ? frame_line_px : diagram_line_px, block.colour,
              frame ? LineStyle::dash : LineStyle::solid);
  if (block.kind == BlockKind::fixed_support) draw_hatching(canvas, block, box, owner);
  if (block.kind == BlockKind::selector) draw_switch(canvas, block, box, owner);
}

}  // namespace tribolog::render
