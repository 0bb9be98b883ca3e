#pragma once
// Wires and the free shapes of a sketch.

#include "render/layout/diagram_canvas.h"

namespace tribolog::render::layout {

/// The arc as a line of short steps.
std::vector<figure::PixelPoint> arc_points(const DiagramCanvas& canvas, const figure::Arc& arc);

void draw_wire(DiagramCanvas& canvas, const figure::Wire& wire, int index);

/// Areas and discs lie below every line.
void draw_shape_fills(DiagramCanvas& canvas, const figure::Diagram& diagram);
/// Strokes, arcs and dimension arrows, numbered on in this order.
void draw_shapes(DiagramCanvas& canvas, const figure::Diagram& diagram);
/// Labels of wires, texts of dimensions and free texts; `texts` of the diagram come last.
void draw_diagram_texts(DiagramCanvas& canvas, const figure::Diagram& diagram);

}  // namespace tribolog::render::layout
