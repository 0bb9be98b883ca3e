#include "render/layout/diagram_layout.h"

#include "render/layout/block_drawing.h"
#include "render/layout/diagram_canvas.h"
#include "render/layout/diagram_checks.h"
#include "render/layout/shape_drawing.h"

namespace tribolog::render::layout {

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
  check_diagram(canvas, diagram);
  faults.malformed += canvas.faults().malformed;
  faults.without_glyph += canvas.faults().without_glyph;
}

}  // namespace tribolog::render::layout
