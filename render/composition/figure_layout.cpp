#include "render/composition/figure_layout.h"

#include <utility>

#include "base/error.h"
#include "render/layout/data_drawing.h"
#include "render/layout/diagram_layout.h"
#include "render/layout/figure_style.h"
#include "render/layout/label_placement.h"
#include "render/layout/legend.h"
#include "render/layout/occupancy.h"
#include "render/layout/panel_frame.h"
#include "render/scene/scene_layout.h"
#include "render/text/utf8.h"

namespace tribolog::render {
namespace {

constexpr int smallest_side = 64;
constexpr int largest_side = 16384;

void check_size(const Figure& figure) {
  for (const int side : {figure.width_px, figure.height_px}) {
    if (side < smallest_side || side > largest_side) {
      throw FigureError("figure size " + std::to_string(figure.width_px) + " x " +
                        std::to_string(figure.height_px) +
                        " pixels is not possible; each side must be 64 to 16384");
    }
  }
}

void report_faults(DrawList& list, const TextFaults& faults) {
  if (faults.malformed > 0) {
    list.warnings.push_back(
        "text that is not valid UTF-8 or holds control characters is shown "
        "as '?'");
  }
  if (!faults.without_glyph.empty()) {
    list.warnings.push_back("the font has no glyph for '" +
                            encode_utf8(faults.without_glyph.substr(0, 10)) + "'; shown as '?'");
  }
}

DrawList scene_list(const Figure& figure, const Font& font) {
  if (!figure.panels.empty()) {
    throw FigureError("a figure has panels or a scene, not both");
  }
  TextFaults faults;
  DrawList list = lay_out_scene(figure, font, faults);
  report_faults(list, faults);
  return list;
}

/// One attempt with given strips; a legend that finds no room inside asks for one.
class Attempt {
 public:
  Attempt(const Figure& figure, const Font& font, const FigureStyle& style,
          std::vector<double> strips)
      : figure_(figure), font_(font), style_(style), strips_(std::move(strips)) {
    list_.width = figure.width_px;
    list_.height = figure.height_px;
    list_.width_mm = figure.width_mm;
  }

  /// False if a strip was added: try again with `strips()`.
  bool run() {
    const FigureFrame frame =
        frame_figure(figure_, font_, style_, strips_, list_.warnings, faults_);
    bool complete = true;
    if (figure_.diagram) {
      lay_out_diagram(list_, figure_, font_, style_, frame.title_bottom, faults_);
    }
    for (std::size_t i = 0; i < frame.panels.size(); ++i) {
      complete = draw_panel(frame.panels[i], i) && complete;
    }
    draw_figure_title(list_, frame, style_);
    report_faults(list_, faults_);
    return complete;
  }

  [[nodiscard]] const std::vector<double>& strips() const { return strips_; }
  DrawList take() { return std::move(list_); }

 private:
  bool draw_panel(const PanelFrame& frame, std::size_t i) {
    const Panel& panel = figure_.panels[i];
    const int index = static_cast<int>(i);
    list_.plots.push_back(frame.plot);
    draw_grid(list_, frame, style_, index);
    const std::size_t first_data = list_.primitives.size();
    draw_data(frame, panel, index);
    Occupancy taken(frame.plot);
    DiscreteMarks marks;
    for (std::size_t k = first_data; k < list_.primitives.size(); ++k) {
      taken.mark(list_.primitives[k]);
      marks.add(list_.primitives[k]);
    }
    for (const PointLabel& point : panel.point_labels) reserve(frame, point, taken, marks);
    draw_axes(list_, frame, font_, style_, index);
    if (!has_drawable_data(panel)) draw_notice(frame, panel.notice, index);
    draw_reference_texts(list_, frame, panel, font_, style_, index, taken, marks, faults_);
    draw_point_labels(list_, frame, panel, font_, style_, index, taken, marks, faults_);
    return draw_legend(frame, panel, i, taken);
  }

  /// Markers of point labels are drawn last, on top of everything; texts keep off them.
  void reserve(const PanelFrame& frame, const PointLabel& point, Occupancy& taken,
               DiscreteMarks& marks) const {
    if (!drawable(point.x, frame.x.logarithmic()) || !drawable(point.y, frame.y.logarithmic())) {
      return;
    }
    const PixelPoint at{frame.x.pixel(point.x), frame.y.pixel(point.y)};
    const PixelBox box = PixelBox{at.x, at.y, at.x, at.y}.grown(7.0 * style_.unit);
    taken.mark(box);
    if (point.marker != Marker::none) marks.add(box);
  }

  void draw_data(const PanelFrame& frame, const Panel& panel, int index) {
    int k = 0;
    for (const Band& band : panel.bands) draw_band(list_, frame, band, {Role::band, index, k++});
    k = 0;
    for (const ErrorBar& bar : panel.error_bars) {
      draw_error_bar(list_, frame, bar, style_, {Role::error_bar, index, k++});
    }
    k = 0;
    for (const Series& one : panel.series) draw_series(list_, frame, one, style_, index, k++);
    k = 0;
    for (const ReferenceLine& line : panel.reference_lines) {
      draw_reference_line(list_, frame, line, style_, {Role::reference_line, index, k++});
    }
  }

  bool draw_legend(const PanelFrame& frame, const Panel& panel, std::size_t i,
                   const Occupancy& taken) {
    const double room = figure_.width_px - 2 * style_.margin;
    const Legend legend(panel, static_cast<int>(i), font_, style_, room, list_.warnings, faults_);
    if (legend.empty()) return true;
    if (strips_[i] > 0) {
      legend.draw_strip(list_, frame.plot, frame.below);
      return true;
    }
    if (legend.draw_inside(list_, frame.plot, taken)) return true;
    strips_[i] = legend.strip_height(room);
    return false;
  }

  void draw_notice(const PanelFrame& frame, const std::string& words, int index) {
    const TextLine line = shape_line(font_, words, style_.axis_title, faults_);
    place_line(list_, line,
               {frame.plot.centre().x - line.width / 2, frame.plot.centre().y + line.ascent / 2},
               true, {Role::notice, index, 0});
  }

  const Figure& figure_;
  const Font& font_;
  const FigureStyle& style_;
  std::vector<double> strips_;
  DrawList list_;
  TextFaults faults_;
};

}  // namespace

DrawList lay_out(const Figure& figure, const Font& font) {
  check_size(figure);
  if (figure.scene) return scene_list(figure, font);
  if (figure.diagram && !figure.panels.empty()) {
    Figure drawing = figure;
    drawing.panels.clear();
    DrawList list = lay_out(drawing, font);
    list.warnings.push_back("a figure is panels or a diagram; its panels are not drawn");
    return list;
  }
  const FigureStyle style(figure);
  std::vector<double> strips(figure.panels.size(), 0.0);
  for (;;) {  // each turn adds a strip, so there are at most panels + 1
    Attempt attempt(figure, font, style, strips);
    if (attempt.run()) return attempt.take();
    strips = attempt.strips();
  }
}

}  // namespace tribolog::render
