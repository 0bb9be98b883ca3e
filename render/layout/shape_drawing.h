#pragma once
// Wires and the free shapes of a sketch.

#include "render/layout/diagram_canvas.h"

namespace tribolog::render {

/// The arc as a line of short steps.
std::vector<PixelPoint> arc_points(const DiagramCanvas& canvas, const Arc& arc);

void draw_wire(DiagramCanvas& canvas, const Wire& wire, int index);

/// Areas and discs lie below every line.
void draw_shape_fills(DiagramCanvas& canvas, const Diagram& diagram);
/// Strokes, arcs and dimension arrows, numbered on in this order.
void draw_shapes(DiagramCanvas& canvas, const Diagram& diagram);
/// Labels of wires, texts of dimensions and free texts; `texts` of the diagram come last.
void draw_diagram_texts(DiagramCanvas& canvas, const Diagram& diagram);

}  // namespace tribolog::render
