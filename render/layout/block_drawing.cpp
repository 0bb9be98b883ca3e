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

namespace {

constexpr double line_pitch = 1.32;       // of an em
constexpr double clearance_mm = 0.35;     // between text and outline
constexpr double sign_inset_mm = 2.2;     // of a sign's centre from the side, in a rectangle
constexpr double sign_share = 0.56;       // of the radius, in a summing junction
constexpr double gain_text_share = 0.37;  // of the width, from the base
constexpr double frame_inset_mm = 1.4;
constexpr double integral_growth = 1.75;

/// Where the text of a block is centred.
PixelPoint text_centre(const PixelBox& box, const Block& block) {
  PixelPoint at = box.centre();
  if (block.kind != BlockKind::gain) return at;
  const double x = (0.5 - gain_text_share) * box.width();
  const double y = (0.5 - gain_text_share) * box.height();
  if (block.faces == BlockSide::right) at.x -= x;
  if (block.faces == BlockSide::left) at.x += x;
  if (block.faces == BlockSide::bottom) at.y -= y;
  if (block.faces == BlockSide::top) at.y += y;
  return at;
}

/// Whether a point lies inside a closed convex outline and not nearer than `clearance` to it.
bool lies_inside(const std::vector<PixelPoint>& outline, PixelPoint p, double clearance) {
  int sides = 0;
  for (std::size_t i = 1; i < outline.size(); ++i) {
    const PixelPoint& a = outline[i - 1];
    const PixelPoint& b = outline[i];
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    if (length < 1e-9) continue;
    const double distance = ((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x)) / length;
    if (std::abs(distance) < clearance) return false;
    const int side = distance > 0 ? 1 : -1;
    if (sides != 0 && side != sides) return false;
    sides = side;
  }
  return true;
}

void check_fit(DiagramCanvas& canvas, const Block& block, std::size_t first_text) {
  const std::vector<PixelPoint> outline = block_outline(canvas, block);
  for (std::size_t i = first_text; i < canvas.texts().size(); ++i) {
    const PlacedText& one = canvas.texts()[i];
    for (const PixelPoint& corner :
         {PixelPoint{one.box.left, one.box.top}, PixelPoint{one.box.right, one.box.top},
          PixelPoint{one.box.left, one.box.bottom}, PixelPoint{one.box.right, one.box.bottom}}) {
      if (lies_inside(outline, corner, canvas.length(clearance_mm))) continue;
      canvas.warn("the text '" + one.text + "' does not fit into its block");
      break;
    }
  }
}

void draw_signs(DiagramCanvas& canvas, const Block& block, const PixelBox& box, Owner owner) {
  const bool round = block.kind == BlockKind::summing_junction;
  const double x =
      box.width() / 2 * (round ? sign_share : 1.0) - (round ? 0.0 : canvas.length(sign_inset_mm));
  const double y =
      box.height() / 2 * (round ? sign_share : 1.0) - (round ? 0.0 : canvas.length(sign_inset_mm));
  for (const PortSign& sign : block.signs) {
    PixelPoint at = box.centre();
    const double offset = canvas.length(sign.offset);
    if (sign.side == BlockSide::left || sign.side == BlockSide::right) {
      at.x += sign.side == BlockSide::left ? -x : x;
      at.y += offset;
    } else {
      at.y += sign.side == BlockSide::top ? -y : y;
      at.x += offset;
    }
    const TextLine line = canvas.shape(sign.text, letter::sign_mm, false, palette::black);
    // Mathematical signs stand lower than the middle of a capital.
    at.y -= 0.05 * line.style.size_px;
    canvas.text(owner, line, at, TextPlace::centre, sign.text, owner.index);
  }
}

}  // namespace

void draw_block_texts(DiagramCanvas& canvas, const Block& block, int index) {
  const Owner owner{Role::block_text, 0, index};
  const PixelBox box = canvas.box(block.centre, block.width, block.height);
  const std::size_t first_text = canvas.texts().size();
  PixelPoint at = text_centre(box, block);
  if (block.kind == BlockKind::integrator) {
    const TextLine sign =
        canvas.shape("∫", integral_growth * letter::block_mm, false, palette::black);
    // The sign reaches below the baseline: its ink is centred, not its capital height.
    at.y += (sign.ascent - sign.descent) / 2 - 0.365 * sign.style.size_px;
    canvas.text(owner, sign, at, TextPlace::centre, "∫", index);
  } else {
    const bool frame = block.kind == BlockKind::frame;
    const double pitch = canvas.length(line_pitch * letter::block_mm);
    at.y -= pitch * (static_cast<double>(block.lines.size()) - 1) / 2;
    if (frame) {
      at.y = box.top + canvas.length(frame_inset_mm) + 0.365 * canvas.length(letter::block_mm);
    }
    for (const std::string& text : block.lines) {
      const TextLine line = canvas.shape(text, letter::block_mm, false, palette::black);
      if (frame) at.x = box.left + canvas.length(frame_inset_mm) + line.width / 2;
      canvas.text(owner, line, at, TextPlace::centre, text, index);
      at.y += pitch;
    }
  }
  draw_signs(canvas, block, box, owner);
  if (block.kind != BlockKind::fixed_support) check_fit(canvas, block, first_text);
}

}  // namespace tribolog::render
