#pragma once
// A drawing to primitives of the draw list.

#include "render/figure/draw_list.h"
#include "render/figure/figure.h"
#include "render/layout/figure_style.h"
#include "render/text/font.h"

namespace tribolog::render::layout {

/// Appends `figure.diagram`, as large as the room below the figure's title allows. What a reader
/// would stumble over is found and reported in `warnings`, see diagram_checks.h.
void lay_out_diagram(figure::DrawList& list, const figure::Figure& figure, const text::Font& font,
                     const FigureStyle& style, double title_bottom, text::TextFaults& faults);

}  // namespace tribolog::render::layout
