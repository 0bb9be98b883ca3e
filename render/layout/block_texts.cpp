#include <algorithm>
#include <cmath>

#include "render/layout/block_drawing.h"

namespace tribolog::render {
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
