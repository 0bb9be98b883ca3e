#include "render/layout/diagram_layout.h"

#include <algorithm>
#include <cmath>

#include "render/figure/figure.h"
#include "render/layout/diagram_drawing.h"
#include "render/layout/polyline.h"

namespace tribolog::render::layout {
namespace {

// What a draughtsman looks for in a finished drawing.

constexpr double reach_mm = 0.05;       // within which a wire's end is on an outline
constexpr double side_px = 1.0;         // what a line may touch of a box without crossing it
constexpr double least_letter_px = 10;  // per em, at a display width of 800 px
constexpr double display_px = 800.0;

/// Warns, naming the text or the part.
class Inspection {
 public:
  Inspection(DiagramCanvas& canvas, const figure::Diagram& diagram)
      : canvas_(canvas), diagram_(diagram) {
    for (const figure::Block& block : diagram.blocks) {
      boxes_.push_back(canvas.box(block.centre, block.width, block.height));
    }
    for (const figure::Wire& wire : diagram.wires) wires_.push_back(canvas.pixels(wire.points));
    for (const figure::Stroke& one : diagram.strokes) sketch_.push_back(canvas.pixels(one.points));
    for (const figure::Arc& one : diagram.arcs) sketch_.push_back(arc_points(canvas, one));
    for (const figure::Dimension& one : diagram.dimensions) {
      sketch_.push_back(canvas.pixels({one.from, one.to}));
    }
  }

  void run() {
    check_texts();
    check_blocks();
    for (std::size_t i = 0; i < wires_.size(); ++i) check_wire(i);
    check_letters();
  }

 private:
  [[nodiscard]] bool is_frame(std::size_t i) const {
    return diagram_.blocks[i].kind == figure::BlockKind::frame;
  }

  [[nodiscard]] Statement name_of_block(std::size_t i) const {
    return figure::name_of_block(diagram_, i);
  }

  void check_texts() {
    const auto& texts = canvas_.texts();
    for (std::size_t i = 0; i < texts.size(); ++i) {
      const Statement name = figure::name_of_text(texts[i].text);
      if (!canvas_.area().contains(texts[i].box)) {
        canvas_.warn({"drawing.outside_canvas", {{"what", name}}});
      }
      for (std::size_t k = i + 1; k < texts.size(); ++k) {
        if (figure::overlap_area(texts[i].box, texts[k].box) > 1.0) {
          canvas_.warn({"drawing.texts_overlap", {{"text", name}, {"other", texts[k].text}}});
        }
      }
      check_text_on_parts(texts[i], name);
    }
  }

  void check_text_on_parts(const PlacedText& text, const Statement& name) {
    const figure::PixelBox core = text.box.grown(-side_px);
    for (std::size_t b = 0; b < boxes_.size(); ++b) {
      if (text.block == static_cast<int>(b)) continue;
      const bool touches = is_frame(b) ? enters(block_outline(canvas_, diagram_.blocks[b]), core)
                                       : figure::overlap_area(core, boxes_[b]) > 0;
      if (touches) {
        canvas_.warn({"drawing.text_on_block", {{"text", name}, {"block", name_of_block(b)}}});
      }
    }
    const bool on_wire = std::any_of(wires_.begin(), wires_.end(),
                                     [&](const auto& wire) { return enters(wire, core); });
    if (on_wire) canvas_.warn({"drawing.text_on_wire", {{"text", name}}});
    const bool on_line = std::any_of(sketch_.begin(), sketch_.end(),
                                     [&](const auto& line) { return enters(line, core); });
    if (on_line) canvas_.warn({"drawing.text_on_line", {{"text", name}}});
  }

  void check_blocks() {
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
      if (!canvas_.area().contains(boxes_[i])) {
        canvas_.warn({"drawing.outside_canvas", {{"what", name_of_block(i)}}});
      }
      for (std::size_t k = i + 1; k < boxes_.size(); ++k) {
        const bool inside = (is_frame(i) && boxes_[i].contains(boxes_[k])) ||
                            (is_frame(k) && boxes_[k].contains(boxes_[i]));
        if (!inside && figure::overlap_area(boxes_[i], boxes_[k]) > 0) {
          canvas_.warn({"drawing.blocks_overlap",
                        {{"block", name_of_block(i)}, {"other", name_of_block(k)}}});
        }
      }
    }
  }

  [[nodiscard]] bool meets_something(figure::PixelPoint end, std::size_t own) const {
    const double reach = canvas_.length(reach_mm);
    for (const figure::Block& block : diagram_.blocks) {
      if (lies_on(block_outline(canvas_, block), end, reach)) return true;
    }
    for (const figure::DiagramPoint& dot : diagram_.wires[own].branch_dots) {
      if (!(canvas_.pixel(dot) == end)) continue;
      for (std::size_t i = 0; i < wires_.size(); ++i) {
        if (i != own && lies_on(wires_[i], end, reach)) return true;
      }
    }
    return false;
  }

  void check_wire(std::size_t i) {
    const Statement name = figure::name_of_wire(i);
    const std::vector<figure::PixelPoint>& wire = wires_[i];
    if (wire.size() < 2) {
      canvas_.warn({"drawing.wire_without_length", {{"wire", name}}});
      return;
    }
    for (const figure::PixelPoint& p : wire) {
      if (!canvas_.area().contains(p)) canvas_.warn({"drawing.outside_canvas", {{"what", name}}});
    }
    for (const figure::PixelPoint& end : {wire.front(), wire.back()}) {
      if (!meets_something(end, i)) {
        canvas_.warn({"drawing.wire_ends_at_nothing", {{"wire", name}}});
      }
    }
    for (std::size_t b = 0; b < boxes_.size(); ++b) {
      if (!is_frame(b) && enters(wire, boxes_[b].grown(-side_px))) {
        canvas_.warn({"drawing.wire_through_block", {{"wire", name}, {"block", name_of_block(b)}}});
      }
    }
  }

  void check_letters() {
    const double px_at_display =
        canvas_.length(letter::sign_mm) * display_px / std::max(1.0, canvas_.picture_width());
    if (px_at_display < least_letter_px) {
      canvas_.warn({"drawing.letters_too_small", {{"width_px", display_px}}});
    }
  }

  DiagramCanvas& canvas_;
  const figure::Diagram& diagram_;
  std::vector<figure::PixelBox> boxes_;
  std::vector<std::vector<figure::PixelPoint>> wires_;
  std::vector<std::vector<figure::PixelPoint>> sketch_;
};

// Whether it can be drawn at all.

constexpr double largest = 1e4;

bool drawable(double number) { return std::isfinite(number) && std::abs(number) <= largest; }

bool drawable(const figure::DiagramPoint& point) { return drawable(point.x) && drawable(point.y); }

bool drawable(const figure::DiagramText& text) { return drawable(text.at); }

bool drawable(const figure::PortSign& sign) { return drawable(sign.offset); }

template <class Item>
bool all_drawable(const std::vector<Item>& items) {
  return std::all_of(items.begin(), items.end(), [](const Item& one) { return drawable(one); });
}

bool drawable_block(const figure::Block& block) {
  return drawable(block.centre) && drawable(block.width) && drawable(block.height) &&
         all_drawable(block.signs);
}

bool drawable_wire(const figure::Wire& wire) {
  return all_drawable(wire.points) && all_drawable(wire.branch_dots) &&
         (!wire.label || drawable(*wire.label));
}

bool drawable_arc(const figure::Arc& arc) {
  return drawable(arc.centre) && drawable(arc.radius) && arc.radius > 0 && drawable(arc.from_deg) &&
         drawable(arc.to_deg) && drawable(arc.width_px);
}

/// False if a coordinate, length or angle is not finite or is beyond 10,000, or an arc has no
/// radius.
bool has_drawable_numbers(const figure::Diagram& diagram) {
  const auto all = [](const auto& items, auto holds) {
    return std::all_of(items.begin(), items.end(), holds);
  };
  return drawable(diagram.width) && drawable(diagram.height) &&
         all(diagram.areas, [](const figure::Area& one) { return all_drawable(one.outline); }) &&
         all(diagram.blocks, drawable_block) && all(diagram.wires, drawable_wire) &&
         all(diagram.strokes,
             [](const figure::Stroke& one) {
               return all_drawable(one.points) && drawable(one.width_px);
             }) &&
         all(diagram.arcs, drawable_arc) &&
         all(diagram.dimensions,
             [](const figure::Dimension& one) { return drawable(one.from) && drawable(one.to); }) &&
         all_drawable(diagram.texts);
}

}  // namespace

void lay_out_diagram(figure::DrawList& list, const figure::Figure& figure, const text::Font& font,
                     const FigureStyle& style, double title_bottom, text::TextFaults& faults) {
  if (!figure.diagram) return;
  const figure::Diagram& diagram = *figure.diagram;
  const figure::PixelBox room{0, title_bottom, static_cast<double>(figure.width_px),
                              figure.height_px - style.margin / 2};
  if (room.height() < style.margin) {
    list.warnings.push_back({"drawing.too_low_for_diagram"});
    return;
  }
  if (!has_drawable_numbers(diagram)) {
    list.warnings.push_back({"drawing.impossible_length"});
    return;
  }
  const double designed_px_per_mm = 10 * style.unit;
  DiagramCanvas canvas(list, diagram, room, font, style.most_diagram_scale * designed_px_per_mm);
  const auto each_block = [&](auto&& draw) {
    int index = 0;
    for (const figure::Block& block : diagram.blocks) draw(canvas, block, index++);
  };
  draw_shape_fills(canvas, diagram);
  each_block(draw_block_fill);
  draw_shapes(canvas, diagram);
  each_block(draw_block);
  int index = 0;
  for (const figure::Wire& wire : diagram.wires) draw_wire(canvas, wire, index++);
  each_block(draw_block_texts);
  draw_diagram_texts(canvas, diagram);
  Inspection(canvas, diagram).run();
  faults.malformed += canvas.faults().malformed;
  faults.without_glyph += canvas.faults().without_glyph;
}

}  // namespace tribolog::render::layout
