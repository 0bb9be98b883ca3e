#pragma once
// A drawing to primitives of the draw list.

#include "render/figure/draw_list.h"
#include "render/figure/figure.h"
#include "render/layout/figure_style.h"
#include "render/text/font.h"

namespace tribolog::render::layout {

/// Appends `figure.diagram`, as large as the room below the figure's title allows. What a reader
/// would stumble over is found and reported in `warnings`: texts that overlap one another, a
/// block's outline, a wire or a line of the sketch; blocks that overlap; a wire through a block, or
/// whose end meets no outline and no wire; anything outside the canvas; letters too small to read
/// at 800 px.
void lay_out_diagram(figure::DrawList& list, const figure::Figure& figure, const text::Font& font,
                     const FigureStyle& style, double title_bottom, text::TextFaults& faults);

}  // namespace tribolog::render::layout
