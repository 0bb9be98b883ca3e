#pragma once
// Arrow heads on a line that show the direction of time.

#include "render/figure/draw_list.h"
#include "render/layout/figure_style.h"
#include "render/layout/panel_frame.h"

namespace tribolog::render {

void draw_direction_arrows(DrawList& list, const PanelFrame& frame, const Series& series,
                           const FigureStyle& style, Owner owner);

}  // namespace tribolog::render
