#pragma once
// The data of a panel as primitives inside its axes box.

#include <string>
#include <vector>

#include "render/figure/draw_list.h"
#include "render/layout/figure_style.h"
#include "render/layout/panel_frame.h"

namespace tribolog::render::layout {

/// Each draws one thing and reports dropped samples to `list.warnings`.
void draw_band(figure::DrawList& list, const PanelFrame& frame, const figure::Band& band,
               figure::Owner owner);
void draw_series(figure::DrawList& list, const PanelFrame& frame, const figure::Series& series,
                 const FigureStyle& style, int panel, int index);
void draw_error_bar(figure::DrawList& list, const PanelFrame& frame, const figure::ErrorBar& bar,
                    const FigureStyle& style, figure::Owner owner);
void draw_reference_line(figure::DrawList& list, const PanelFrame& frame,
                         const figure::ReferenceLine& line, const FigureStyle& style,
                         figure::Owner owner);

/// Whether anything in the panel can be drawn on its axes.
bool has_drawable_data(const figure::Panel& panel);

}  // namespace tribolog::render::layout
