#include <algorithm>
#include <cmath>

#include "render/layout/panel_drawing.h"

namespace tribolog::render::layout {
namespace {

void draw_line(figure::DrawList& list, figure::Owner owner, figure::PixelPoint a,
               figure::PixelPoint b, double width, figure::Colour colour) {
  list.primitives.emplace_back(figure::Polyline{owner, {a, b}, width, colour, {}});
}

double line_pitch(const text::TextLine& line) { return 1.28 * line.style.size_px; }

void draw_ticks(figure::DrawList& list, const PanelFrame& frame, const text::Font& font,
                const FigureStyle& style, int panel) {
  const figure::Owner axis{figure::Role::axis, panel, 0};
  text::TextFaults none;
  const auto mark_x = [&](double value, double length) {
    const double x = frame.x.pixel(value);
    draw_line(list, axis, {x, frame.plot.bottom}, {x, frame.plot.bottom + length}, style.axis_width,
              ink::axis);
  };
  const auto mark_y = [&](double value, double length) {
    const double y = frame.y.pixel(value);
    draw_line(list, axis, {frame.plot.left - length, y}, {frame.plot.left, y}, style.axis_width,
              ink::axis);
  };
  for (const double value : frame.x_ticks.minor) mark_x(value, style.tick_mark / 2);
  for (const double value : frame.y_ticks.minor) mark_y(value, style.tick_mark / 2);
  int index = 0;
  for (const Tick& tick : frame.x_ticks.major) {
    mark_x(tick.value, style.tick_mark);
    if (!frame.shows_x) continue;
    const text::TextLine label = text::shape_line(font, tick.label, style.tick, none);
    text::place_line(list, label,
                     {frame.x.pixel(tick.value) - label.width / 2,
                      frame.plot.bottom + style.tick_mark + style.gap + label.ascent},
                     true, {figure::Role::tick_label, panel, index++});
  }
  for (const Tick& tick : frame.y_ticks.major) {
    mark_y(tick.value, style.tick_mark);
    const text::TextLine label = text::shape_line(font, tick.label, style.tick, none);
    const double digit_height = 0.73 * style.tick.size_px;
    text::place_line(list, label,
                     {frame.plot.left - style.tick_mark - style.gap - label.width,
                      frame.y.pixel(tick.value) + digit_height / 2},
                     true, {figure::Role::tick_label, panel, index++});
  }
}

void draw_scale_notes(figure::DrawList& list, const PanelFrame& frame, const text::Font& font,
                      const FigureStyle& style, int panel) {
  text::TextFaults none;
  if (!frame.y_ticks.scale_note.empty()) {
    const text::TextLine note = text::shape_line(font, frame.y_ticks.scale_note, style.tick, none);
    const double left = std::max(style.margin, frame.plot.left - style.tick_mark - note.width / 2);
    text::place_line(list, note, {left, frame.plot.top - style.gap - note.descent}, true,
                     {figure::Role::scale_note, panel, 1});
  }
  if (frame.shows_x && !frame.x_ticks.scale_note.empty()) {
    const text::TextLine note = text::shape_line(font, frame.x_ticks.scale_note, style.tick, none);
    const double top =
        frame.plot.bottom + style.tick_mark + style.gap + 1.28 * style.tick.size_px + style.gap;
    text::place_line(list, note, {frame.plot.right - note.width, top + note.ascent}, true,
                     {figure::Role::scale_note, panel, 0});
  }
}

void draw_titles(figure::DrawList& list, const PanelFrame& frame, const FigureStyle& style,
                 int panel) {
  double y = frame.plot.top - style.gap / 2;
  for (auto line = frame.title.rbegin(); line != frame.title.rend(); ++line) {
    text::place_line(list, *line,
                     {frame.plot.centre().x - line->width / 2, y - 0.28 * line->style.size_px},
                     true, {figure::Role::panel_title, panel, 0});
    y -= line_pitch(*line);
  }
  y = frame.plot.bottom + style.tick_mark + style.gap + 1.28 * style.tick.size_px + style.gap / 2;
  for (const text::TextLine& line : frame.x_title) {
    double x = frame.plot.centre().x - line.width / 2;
    text::place_line(list, line, {x, y + line.style.size_px}, true,
                     {figure::Role::axis_title, panel, 0});
    y += line_pitch(line);
  }
  double x = frame.y_title_left;
  for (const text::TextLine& line : frame.y_title) {
    const double lowest = list.height - style.margin / 2;
    double start = std::min(frame.plot.centre().y + line.width / 2, lowest);
    text::place_line(list, line, {x + 0.95 * line.style.size_px, start}, false,
                     {figure::Role::axis_title, panel, 1});
    x += line_pitch(line);
  }
}

}  // namespace

void draw_grid(figure::DrawList& list, const PanelFrame& frame, const FigureStyle& style,
               int panel) {
  const figure::Owner owner{figure::Role::grid, panel, 0};
  for (const Tick& tick : frame.x_ticks.major) {
    const double x = frame.x.pixel(tick.value);
    draw_line(list, owner, {x, frame.plot.top}, {x, frame.plot.bottom}, style.grid_width,
              ink::grid);
  }
  for (const Tick& tick : frame.y_ticks.major) {
    const double y = frame.y.pixel(tick.value);
    draw_line(list, owner, {frame.plot.left, y}, {frame.plot.right, y}, style.grid_width,
              ink::grid);
  }
}

void draw_axes(figure::DrawList& list, const PanelFrame& frame, const text::Font& font,
               const FigureStyle& style, int panel) {
  const auto [left, top, right, bottom] = frame.plot;
  list.primitives.emplace_back(
      figure::Polyline{{figure::Role::axis, panel, 0},
                       {{left, top}, {right, top}, {right, bottom}, {left, bottom}, {left, top}},
                       style.axis_width,
                       ink::axis,
                       {}});
  draw_ticks(list, frame, font, style, panel);
  draw_scale_notes(list, frame, font, style, panel);
  draw_titles(list, frame, style, panel);
}

void draw_figure_title(figure::DrawList& list, const FigureFrame& frame, const FigureStyle& style) {
  double y = style.margin;
  for (const text::TextLine& line : frame.title) {
    text::place_line(list, line, {(list.width - line.width) / 2, y + 0.85 * line.style.size_px},
                     true, {figure::Role::figure_title, 0, 0});
    y += line_pitch(line);
  }
}

}  // namespace tribolog::render::layout
