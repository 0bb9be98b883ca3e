#include "render/composition/figure_layout.h"

#include <utility>

#include "base/error.h"
#include "render/layout/diagram_layout.h"
#include "render/layout/figure_style.h"
#include "render/layout/label_placement.h"
#include "render/layout/legend.h"
#include "render/layout/occupancy.h"
#include "render/layout/panel_drawing.h"
#include "render/scene/scene_layout.h"
#include "render/text/characters.h"

namespace tribolog::render::composition {
namespace {

constexpr int smallest_side = 64;
constexpr int largest_side = 16384;

void check_size(const figure::Figure& figure) {
  for (const int side : {figure.width_px, figure.height_px}) {
    if (side < smallest_side || side > largest_side) {
      throw FigureError({"drawing.impossible_size",
                         {{"width", figure.width_px},
                          {"height", figure.height_px},
                          {"smallest", smallest_side},
                          {"largest", largest_side}}});
    }
  }
}

void report_faults(figure::DrawList& list, const text::TextFaults& faults) {
  if (faults.malformed > 0) {
    list.warnings.push_back({"drawing.text_not_valid"});
  }
  if (!faults.without_glyph.empty()) {
    list.warnings.push_back(
        {"drawing.no_glyph",
         {{"characters", text::encode_utf8(faults.without_glyph.substr(0, 10))}}});
  }
}

figure::DrawList scene_list(const figure::Figure& figure, const text::Font& font) {
  if (!figure.panels.empty()) {
    throw FigureError({"drawing.panels_and_scene"});
  }
  text::TextFaults faults;
  figure::DrawList list = scene::lay_out_scene(figure, font, faults);
  report_faults(list, faults);
  return list;
}

/// One attempt with given strips; a legend that finds no room inside asks for one.
class Attempt {
 public:
  Attempt(const figure::Figure& figure, const text::Font& font, const layout::FigureStyle& style,
          std::vector<double> strips)
      : figure_(figure), font_(font), style_(style), strips_(std::move(strips)) {
    list_.width = figure.width_px;
    list_.height = figure.height_px;
    list_.width_mm = figure.width_mm;
  }

  /// False if a strip was added: try again with `strips()`.
  bool run() {
    const layout::FigureFrame frame =
        layout::frame_figure(figure_, font_, style_, strips_, list_.warnings, faults_);
    bool complete = true;
    if (figure_.diagram) {
      layout::lay_out_diagram(list_, figure_, font_, style_, frame.title_bottom, faults_);
    }
    for (std::size_t i = 0; i < frame.panels.size(); ++i) {
      complete = draw_panel(frame.panels[i], i) && complete;
    }
    layout::draw_figure_title(list_, frame, style_);
    report_faults(list_, faults_);
    return complete;
  }

  [[nodiscard]] const std::vector<double>& strips() const { return strips_; }
  figure::DrawList take() { return std::move(list_); }

 private:
  bool draw_panel(const layout::PanelFrame& frame, std::size_t i) {
    const figure::Panel& panel = figure_.panels[i];
    const int index = static_cast<int>(i);
    list_.plots.push_back(frame.plot);
    layout::draw_grid(list_, frame, style_, index);
    const std::size_t first_data = list_.primitives.size();
    draw_data(frame, panel, index);
    layout::Occupancy taken(frame.plot);
    layout::DiscreteMarks marks;
    for (std::size_t k = first_data; k < list_.primitives.size(); ++k) {
      taken.mark(list_.primitives[k]);
      marks.add(list_.primitives[k]);
    }
    for (const figure::PointLabel& point : panel.point_labels) reserve(frame, point, taken, marks);
    layout::draw_axes(list_, frame, font_, style_, index);
    if (!layout::has_drawable_data(panel)) draw_notice(frame, panel.notice, index);
    layout::draw_reference_texts(list_, frame, panel, font_, style_, index, taken, marks, faults_);
    layout::draw_point_labels(list_, frame, panel, font_, style_, index, taken, marks, faults_);
    return draw_legend(frame, panel, i, taken);
  }

  /// Markers of point labels are drawn last, on top of everything; texts keep off them.
  void reserve(const layout::PanelFrame& frame, const figure::PointLabel& point,
               layout::Occupancy& taken, layout::DiscreteMarks& marks) const {
    if (!layout::drawable(point.x, frame.x.logarithmic()) ||
        !layout::drawable(point.y, frame.y.logarithmic())) {
      return;
    }
    const figure::PixelPoint at{frame.x.pixel(point.x), frame.y.pixel(point.y)};
    const figure::PixelBox box = figure::PixelBox{at.x, at.y, at.x, at.y}.grown(7.0 * style_.unit);
    taken.mark(box);
    if (point.marker != figure::Marker::none) marks.add(box);
  }

  void draw_data(const layout::PanelFrame& frame, const figure::Panel& panel, int index) {
    int k = 0;
    for (const figure::Band& band : panel.bands)
      layout::draw_band(list_, frame, band, {figure::Role::band, index, k++});
    k = 0;
    for (const figure::ErrorBar& bar : panel.error_bars) {
      layout::draw_error_bar(list_, frame, bar, style_, {figure::Role::error_bar, index, k++});
    }
    k = 0;
    for (const figure::Series& one : panel.series)
      layout::draw_series(list_, frame, one, style_, index, k++);
    k = 0;
    for (const figure::ReferenceLine& line : panel.reference_lines) {
      layout::draw_reference_line(list_, frame, line, style_,
                                  {figure::Role::reference_line, index, k++});
    }
  }

  bool draw_legend(const layout::PanelFrame& frame, const figure::Panel& panel, std::size_t i,
                   const layout::Occupancy& taken) {
    const double room = panel.labels_at_ends
                            ? figure_.width_px - style_.margin - frame.plot.right - style_.gap
                            : figure_.width_px - 2 * style_.margin;
    const layout::Legend legend(panel, static_cast<int>(i), font_, style_, room, list_.warnings,
                                faults_);
    if (legend.empty()) return true;
    if (panel.labels_at_ends) {
      legend.draw_beside(list_, frame);
      return true;
    }
    if (strips_[i] > 0) {
      legend.draw_strip(list_, frame.plot, frame.below);
      return true;
    }
    if (legend.draw_inside(list_, frame.plot, taken)) return true;
    strips_[i] = legend.strip_height(room);
    return false;
  }

  void draw_notice(const layout::PanelFrame& frame, const std::string& words, int index) {
    const text::TextLine line = text::shape_line(font_, words, style_.axis_title, faults_);
    text::place_line(
        list_, line,
        {frame.plot.centre().x - line.width / 2, frame.plot.centre().y + line.ascent / 2}, true,
        {figure::Role::notice, index, 0});
  }

  const figure::Figure& figure_;
  const text::Font& font_;
  const layout::FigureStyle& style_;
  std::vector<double> strips_;
  figure::DrawList list_;
  text::TextFaults faults_;
};

}  // namespace

figure::DrawList lay_out(const figure::Figure& figure, const text::Font& font) {
  check_size(figure);
  if (figure.scene) return scene_list(figure, font);
  if (figure.diagram && !figure.panels.empty()) {
    figure::Figure drawing = figure;
    drawing.panels.clear();
    figure::DrawList list = lay_out(drawing, font);
    list.warnings.push_back({"drawing.panels_and_diagram"});
    return list;
  }
  const layout::FigureStyle style(figure);
  std::vector<double> strips(figure.panels.size(), 0.0);
  for (;;) {  // each turn adds a strip, so there are at most panels + 1
    Attempt attempt(figure, font, style, strips);
    if (attempt.run()) return attempt.take();
    strips = attempt.strips();
  }
}

}  // namespace tribolog::render::composition
