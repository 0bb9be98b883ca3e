#pragma once
// Where the panels of a figure, their axes and their titles go, and how they and their data are
// drawn.

#include <string>
#include <vector>

#include "render/figure/draw_list.h"
#include "render/layout/axis.h"
#include "render/layout/figure_style.h"

namespace tribolog::render::layout {

struct PanelFrame {
  figure::PixelBox plot;  ///< The axes box.
  AxisMap x;
  AxisMap y;
  TickSet x_ticks;
  TickSet y_ticks;
  bool shows_x{true};  ///< Whether x tick labels and title stand below.
  std::vector<text::TextLine> title;
  std::vector<text::TextLine> x_title;
  std::vector<text::TextLine> y_title;
  double y_title_left{};  ///< Left edge of the turned title.
  double below{};         ///< Where free room for a legend strip starts.
};

struct FigureFrame {
  std::vector<text::TextLine> title;
  double title_bottom{};  ///< Where the room below the title starts.
  std::vector<PanelFrame> panels;
};

/// Divides the picture. `strip_heights` is the room to keep below each panel for its legend.
/// Complaints (texts cut, no room) go to `warnings`, unprintable text to `faults`.
FigureFrame frame_figure(const figure::Figure& figure, const text::Font& font,
                         const FigureStyle& style, const std::vector<double>& strip_heights,
                         std::vector<Statement>& warnings, text::TextFaults& faults);

/// Draws grid, and (after the data) box, ticks and titles.
void draw_grid(figure::DrawList& list, const PanelFrame& frame, const FigureStyle& style,
               int panel);
void draw_axes(figure::DrawList& list, const PanelFrame& frame, const text::Font& font,
               const FigureStyle& style, int panel);
void draw_figure_title(figure::DrawList& list, const FigureFrame& frame, const FigureStyle& style);

// The data of a panel as primitives inside its axes box.

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
