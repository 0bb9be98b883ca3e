#pragma once
// What a draughtsman looks for in a finished drawing.

#include "render/layout/diagram_canvas.h"

namespace tribolog::render::layout {

/// False if a coordinate, length or angle is not finite or is beyond 10,000, or an arc has no
/// radius.
bool has_drawable_numbers(const figure::Diagram& diagram);

/// Warns, naming the text or the part, of: texts that overlap one another, a block's outline, a
/// wire or a line of the sketch; blocks that overlap; a wire through a block, or whose end meets no
/// outline and no wire; anything outside the canvas; letters too small to read at 800 px.
void check_diagram(DiagramCanvas& canvas, const figure::Diagram& diagram);

}  // namespace tribolog::render::layout
