#include <algorithm>
#include <cmath>
#include <numbers>

#include "render/figure/figure.h"
#include "render/layout/diagram_drawing.h"

namespace tribolog::render::layout {

namespace {

constexpr int circle_corners = 72;
constexpr double frame_line_px = 2.0;
constexpr double hatch_pitch_mm = 2.0;
constexpr double hatch_line_px = 2.0;

/// Points of an arc around `c`, angles in quarter turns.
void add_arc(std::vector<figure::PixelPoint>& out, figure::PixelPoint c, double radius, double from,
             double to) {
  const int steps = std::max(2, static_cast<int>(std::abs(to - from) * circle_corners / 4));
  for (int i = 0; i <= steps; ++i) {
    const double angle = (from + (to - from) * i / steps) * std::numbers::pi / 2;
    out.push_back({c.x + radius * std::cos(angle), c.y + radius * std::sin(angle)});
  }
}

std::vector<figure::PixelPoint> rounded(const figure::PixelBox& box) {
  const double radius = std::min(box.width(), box.height()) / 2;
  std::vector<figure::PixelPoint> out;
  add_arc(out, {box.right - radius, box.bottom - radius}, radius, 0, 1);
  add_arc(out, {box.left + radius, box.bottom - radius}, radius, 1, 2);
  add_arc(out, {box.left + radius, box.top + radius}, radius, 2, 3);
  add_arc(out, {box.right - radius, box.top + radius}, radius, 3, 4);
  out.push_back(out.front());
  return out;
}

std::vector<figure::PixelPoint> triangle(const figure::PixelBox& box, figure::BlockSide tip) {
  const figure::PixelPoint c = box.centre();
  switch (tip) {
    case figure::BlockSide::left:
      return {{box.left, c.y}, {box.right, box.top}, {box.right, box.bottom}, {box.left, c.y}};
    case figure::BlockSide::top:
      return {{c.x, box.top}, {box.right, box.bottom}, {box.left, box.bottom}, {c.x, box.top}};
    case figure::BlockSide::bottom:
      return {{c.x, box.bottom}, {box.left, box.top}, {box.right, box.top}, {c.x, box.bottom}};
    case figure::BlockSide::right:
      break;
  }
  return {{box.right, c.y}, {box.left, box.bottom}, {box.left, box.top}, {box.right, c.y}};
}

std::vector<figure::PixelPoint> rectangle(const figure::PixelBox& box) {
  return {{box.left, box.top},
          {box.right, box.top},
          {box.right, box.bottom},
          {box.left, box.bottom},
          {box.left, box.top}};
}

std::vector<figure::PixelPoint> surface(const figure::PixelBox& box, figure::BlockSide side) {
  switch (side) {
    case figure::BlockSide::left:
      return {{box.left, box.top}, {box.left, box.bottom}};
    case figure::BlockSide::right:
      return {{box.right, box.top}, {box.right, box.bottom}};
    case figure::BlockSide::bottom:
      return {{box.left, box.bottom}, {box.right, box.bottom}};
    case figure::BlockSide::top:
      break;
  }
  return {{box.left, box.top}, {box.right, box.top}};
}

/// Slanted lines from the surface through the depth of the box.
void draw_hatching(DiagramCanvas& canvas, const figure::Block& block, const figure::PixelBox& box,
                   figure::Owner owner) {
  const bool level =
      block.faces == figure::BlockSide::top || block.faces == figure::BlockSide::bottom;
  const double run = level ? box.width() : box.height();
  const double depth = level ? box.height() : box.width();
  const int count = std::max(1, static_cast<int>((run - depth) / canvas.length(hatch_pitch_mm)));
  for (int i = 0; i <= count; ++i) {
    const double along = depth + (run - depth) * i / count;
    figure::PixelPoint from;
    figure::PixelPoint to;
    if (level) {
      const bool up = block.faces == figure::BlockSide::top;
      from = {box.left + along, up ? box.top : box.bottom};
      to = {from.x - depth, up ? box.bottom : box.top};
    } else {
      const bool at_left = block.faces == figure::BlockSide::left;
      from = {at_left ? box.left : box.right, box.top + along};
      to = {at_left ? box.right : box.left, from.y - depth};
    }
    canvas.line(owner, {from, to}, hatch_line_px, block.colour);
  }
}

void draw_switch(DiagramCanvas& canvas, const figure::Block& block, const figure::PixelBox& box,
                 figure::Owner owner) {
  const double ahead = block.faces == figure::BlockSide::left ? -1.0 : 1.0;
  const figure::PixelPoint c = box.centre();
  const double x = 0.24 * box.width() * ahead;
  const double y = 0.25 * box.height();
  const double edge = 0.5 * box.width() * ahead;
  canvas.line(owner, {{c.x - edge, c.y - y}, {c.x - x, c.y - y}, {c.x + x, c.y}, {c.x + edge, c.y}},
              diagram_line_px, block.colour);
  canvas.line(owner, {{c.x - edge, c.y + y}, {c.x - x, c.y + y}}, diagram_line_px, block.colour);
  for (const figure::PixelPoint& at :
       {figure::PixelPoint{c.x - x, c.y - y}, figure::PixelPoint{c.x - x, c.y + y},
        figure::PixelPoint{c.x + x, c.y}}) {
    std::vector<figure::PixelPoint> dot;
    add_arc(dot, at, canvas.length(0.55), 0, 4);
    canvas.filled(owner, std::move(dot), block.colour);
  }
}

}  // namespace

std::vector<figure::PixelPoint> block_outline(const DiagramCanvas& canvas,
                                              const figure::Block& block) {
  const figure::PixelBox box = canvas.box(block.centre, block.width, block.height);
  switch (block.kind) {
    case figure::BlockKind::gain:
      return triangle(box, block.faces);
    case figure::BlockKind::summing_junction: {
      std::vector<figure::PixelPoint> circle;
      add_arc(circle, box.centre(), box.width() / 2, 0, 4);
      circle.back() = circle.front();
      return circle;
    }
    case figure::BlockKind::terminal:
      return rounded(box);
    case figure::BlockKind::fixed_support:
      return surface(box, block.faces);
    default:
      return rectangle(box);
  }
}

void draw_block_fill(DiagramCanvas& canvas, const figure::Block& block, int index) {
  if (block.kind == figure::BlockKind::fixed_support || block.fill.alpha == 0) return;
  std::vector<figure::PixelPoint> outline = block_outline(canvas, block);
  outline.pop_back();
  canvas.filled({figure::Role::block_fill, 0, index}, std::move(outline), block.fill);
}

void draw_block(DiagramCanvas& canvas, const figure::Block& block, int index) {
  const figure::Owner owner{figure::Role::block, 0, index};
  const figure::PixelBox box = canvas.box(block.centre, block.width, block.height);
  const bool frame = block.kind == figure::BlockKind::frame;
  std::vector<figure::PixelPoint> outline = block_outline(canvas, block);
  // Once more along the first side, so that the closing corner is joined like the others.
  if (block.kind != figure::BlockKind::fixed_support && !frame) outline.push_back(outline[1]);
  canvas.line(owner, std::move(outline), frame ? frame_line_px : diagram_line_px, block.colour,
              frame ? figure::LineStyle::dash : figure::LineStyle::solid);
  if (block.kind == figure::BlockKind::fixed_support) draw_hatching(canvas, block, box, owner);
  if (block.kind == figure::BlockKind::selector) draw_switch(canvas, block, box, owner);
}

namespace {

constexpr double block_line_pitch = 1.32;  // of an em
constexpr double clearance_mm = 0.35;      // between text and outline
constexpr double sign_inset_mm = 2.2;      // of a sign's centre from the side, in a rectangle
constexpr double sign_share = 0.56;        // of the radius, in a summing junction
constexpr double gain_text_share = 0.37;   // of the width, from the base
constexpr double frame_inset_mm = 1.4;
constexpr double integral_growth = 1.75;

/// Where the text of a block is centred.
figure::PixelPoint text_centre(const figure::PixelBox& box, const figure::Block& block) {
  figure::PixelPoint at = box.centre();
  if (block.kind != figure::BlockKind::gain) return at;
  const double x = (0.5 - gain_text_share) * box.width();
  const double y = (0.5 - gain_text_share) * box.height();
  if (block.faces == figure::BlockSide::right) at.x -= x;
  if (block.faces == figure::BlockSide::left) at.x += x;
  if (block.faces == figure::BlockSide::bottom) at.y -= y;
  if (block.faces == figure::BlockSide::top) at.y += y;
  return at;
}

/// Whether a point lies inside a closed convex outline and not nearer than `clearance` to it.
bool lies_inside(const std::vector<figure::PixelPoint>& outline, figure::PixelPoint p,
                 double clearance) {
  int sides = 0;
  for (std::size_t i = 1; i < outline.size(); ++i) {
    const figure::PixelPoint& a = outline[i - 1];
    const figure::PixelPoint& b = outline[i];
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

void check_fit(DiagramCanvas& canvas, const figure::Block& block, std::size_t first_text) {
  const std::vector<figure::PixelPoint> outline = block_outline(canvas, block);
  for (std::size_t i = first_text; i < canvas.texts().size(); ++i) {
    const PlacedText& one = canvas.texts()[i];
    for (const figure::PixelPoint& corner : {figure::PixelPoint{one.box.left, one.box.top},
                                             figure::PixelPoint{one.box.right, one.box.top},
                                             figure::PixelPoint{one.box.left, one.box.bottom},
                                             figure::PixelPoint{one.box.right, one.box.bottom}}) {
      if (lies_inside(outline, corner, canvas.length(clearance_mm))) continue;
      canvas.warn({"drawing.does_not_fit", {{"text", figure::name_of_text(one.text)}}});
      break;
    }
  }
}

void draw_signs(DiagramCanvas& canvas, const figure::Block& block, const figure::PixelBox& box,
                figure::Owner owner) {
  const bool round = block.kind == figure::BlockKind::summing_junction;
  const double x =
      box.width() / 2 * (round ? sign_share : 1.0) - (round ? 0.0 : canvas.length(sign_inset_mm));
  const double y =
      box.height() / 2 * (round ? sign_share : 1.0) - (round ? 0.0 : canvas.length(sign_inset_mm));
  for (const figure::PortSign& sign : block.signs) {
    figure::PixelPoint at = box.centre();
    const double offset = canvas.length(sign.offset);
    if (sign.side == figure::BlockSide::left || sign.side == figure::BlockSide::right) {
      at.x += sign.side == figure::BlockSide::left ? -x : x;
      at.y += offset;
    } else {
      at.y += sign.side == figure::BlockSide::top ? -y : y;
      at.x += offset;
    }
    const text::TextLine line =
        canvas.shape(sign.text, letter::sign_mm, false, figure::palette::black);
    // Mathematical signs stand lower than the middle of a capital.
    at.y -= 0.05 * line.style.size_px;
    canvas.text(owner, line, at, figure::TextPlace::centre, sign.text, owner.index);
  }
}

}  // namespace

void draw_block_texts(DiagramCanvas& canvas, const figure::Block& block, int index) {
  const figure::Owner owner{figure::Role::block_text, 0, index};
  const figure::PixelBox box = canvas.box(block.centre, block.width, block.height);
  const std::size_t first_text = canvas.texts().size();
  figure::PixelPoint at = text_centre(box, block);
  if (block.kind == figure::BlockKind::integrator) {
    const text::TextLine sign =
        canvas.shape("∫", integral_growth * letter::block_mm, false, figure::palette::black);
    // The sign reaches below the baseline: its ink is centred, not its capital height.
    at.y += (sign.ascent - sign.descent) / 2 - 0.365 * sign.style.size_px;
    canvas.text(owner, sign, at, figure::TextPlace::centre, "∫", index);
  } else {
    const bool frame = block.kind == figure::BlockKind::frame;
    const double pitch = canvas.length(block_line_pitch * letter::block_mm);
    at.y -= pitch * (static_cast<double>(block.lines.size()) - 1) / 2;
    if (frame) {
      at.y = box.top + canvas.length(frame_inset_mm) + 0.365 * canvas.length(letter::block_mm);
    }
    for (const std::string& text : block.lines) {
      const text::TextLine line =
          canvas.shape(text, letter::block_mm, false, figure::palette::black);
      if (frame) at.x = box.left + canvas.length(frame_inset_mm) + line.width / 2;
      canvas.text(owner, line, at, figure::TextPlace::centre, text, index);
      at.y += pitch;
    }
  }
  draw_signs(canvas, block, box, owner);
  if (block.kind != figure::BlockKind::fixed_support) check_fit(canvas, block, first_text);
}

}  // namespace tribolog::render::layout
