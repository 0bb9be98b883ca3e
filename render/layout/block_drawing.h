#pragma once
// Blocks of a diagram: what each kind looks like.

#include "render/layout/diagram_canvas.h"

namespace tribolog::render::layout {

/// The outline that wires end on, in pixels and closed (the last point repeats the first); for a
/// fixed support the line of its surface.
std::vector<figure::PixelPoint> block_outline(const DiagramCanvas& canvas,
                                              const figure::Block& block);

/// Fills must lie below every line, so they are drawn by a call of their own, before the outlines.
void draw_block_fill(DiagramCanvas& canvas, const figure::Block& block, int index);
void draw_block(DiagramCanvas& canvas, const figure::Block& block, int index);

/// Text and port signs. Warns of text that does not fit into the block.
void draw_block_texts(DiagramCanvas& canvas, const figure::Block& block, int index);

}  // namespace tribolog::render::layout
