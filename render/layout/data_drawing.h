#pragma once
// The data of a panel as primitives inside its axes box.

#include <string>
#include <vector>

#include "render/figure/draw_list.h"
#include "render/layout/figure_style.h"
#include "render/layout/panel_frame.h"

namespace tribolog::render {

/// Each draws one thing and reports dropped samples to `list.warnings`.
void draw_band(DrawList& list, const PanelFrame& frame, const Band& band, Owner owner);
void draw_series(DrawList& list, const PanelFrame& frame, const Series& series,
                 const FigureStyle& style, int panel, int index);
void draw_error_bar(DrawList& list, const PanelFrame& frame, const ErrorBar& bar,
                    const FigureStyle& style, Owner owner);
void draw_reference_line(DrawList& list, const PanelFrame& frame, const ReferenceLine& line,
                         const FigureStyle& style, Owner owner);

/// Whether anything in the panel can be drawn on its axes.
bool has_drawable_data(const Panel& panel);

}  // namespace tribolog::render
