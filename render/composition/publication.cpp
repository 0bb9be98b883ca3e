#include "render/composition/publication.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "render/composition/figure_layout.h"
#include "render/layout/figure_style.h"

namespace tribolog::render::composition {
namespace {

using namespace publication;

struct PanelHeights {
  double lone_mm{};  ///< Of a chart with one panel.
  double plot_mm{};
  double head_mm{};  ///< Title and scale note above a plot.
  double axis_mm{};  ///< Tick labels and title below one.
};
constexpr PanelHeights in_one_column{60, 36, 5, 10};
constexpr PanelHeights in_two_columns{74, 52, 5, 10};

int pixels(double mm) { return static_cast<int>(std::lround(mm * publication::px_per_mm)); }

double chart_height_mm(const figure::Figure& figure, bool two_columns) {
  const PanelHeights& heights = two_columns ? in_two_columns : in_one_column;
  const auto panels = static_cast<double>(figure.panels.size());
  if (figure.panels.size() < 2) {
    constexpr double name_mm = 4.0;  // from one name on an axis to the next
    double names = 0;
    for (const figure::Panel& panel : figure.panels)
      names += static_cast<double>(panel.y.names.size());
    return std::clamp(heights.head_mm + heights.axis_mm + name_mm * names, heights.lone_mm,
                      publication::highest_mm);
  }
  const double axes = figure.panels_share_x ? 1.0 : panels;
  return std::min(publication::highest_mm,
                  panels * (heights.plot_mm + heights.head_mm) + axes * heights.axis_mm);
}

double diagram_height_mm(const figure::Diagram& diagram, const figure::Figure& figure) {
  const layout::FigureStyle style(figure);
  const double scale = std::min(style.most_diagram_scale, figure.width_mm / diagram.width);
  return scale * diagram.height + 1.5 * style.margin / publication::px_per_mm;
}

figure::Figure in_columns(figure::Figure figure, bool two_columns, double shape) {
  figure.width_mm = two_columns ? publication::double_column_mm : publication::single_column_mm;
  figure.width_px = pixels(figure.width_mm);
  const double height_mm = figure.diagram ? diagram_height_mm(*figure.diagram, figure)
                           : figure.scene ? shape * figure.width_mm
                                          : chart_height_mm(figure, two_columns);
  figure.height_px = pixels(height_mm);
  return figure;
}

/// Whether the letters of a drawing remain large enough in one column.
bool is_narrow(const figure::Diagram& diagram) {
  constexpr double least_scale = 0.85;
  return least_scale * diagram.width <= publication::single_column_mm;
}

/// Texts that were cut for want of room.
std::size_t cut_texts(const figure::DrawList& list) {
  const auto is_cut = [](const figure::Primitive& one) {
    const auto* run = std::get_if<figure::TextRun>(&one);
    return run != nullptr && run->text.ends_with("…");
  };
  return static_cast<std::size_t>(
      std::count_if(list.primitives.begin(), list.primitives.end(), is_cut));
}

/// Length of curves and of a scene's lines on which a label stands.
double covered_mm(const figure::DrawList& list) {
  constexpr double step_px = 2.0;
  std::vector<figure::PixelBox> labels;
  for (const figure::Primitive& one : list.primitives) {
    const auto* run = std::get_if<figure::TextRun>(&one);
    if (run == nullptr) continue;
    const figure::Role role = run->owner.role;
    if (role == figure::Role::label_text || role == figure::Role::reference_text)
      labels.push_back(run->box);
  }
  double covered_px = 0;
  const auto walk = [&](figure::PixelPoint a, figure::PixelPoint b) {
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    const int steps = static_cast<int>(length / step_px) + 1;
    for (int i = 0; i < steps; ++i) {
      const double t = (i + 0.5) / steps;
      const figure::PixelPoint p{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
      const bool hidden = std::any_of(labels.begin(), labels.end(),
                                      [&](const figure::PixelBox& box) { return box.contains(p); });
      if (hidden) covered_px += length / steps;
    }
  };
  for (const figure::Primitive& one : list.primitives) {
    const auto* line = std::get_if<figure::Polyline>(&one);
    if (line == nullptr) continue;
    if (line->owner.role != figure::Role::series && line->owner.role != figure::Role::scene_line)
      continue;
    for (std::size_t i = 1; i < line->points.size(); ++i)
      walk(line->points[i - 1], line->points[i]);
  }
  return covered_px / publication::px_per_mm;
}

/// Whether a chart or scene shows in one column all that it shows in two.
bool fits_in_one(const figure::Figure& one, const figure::Figure& two, const text::Font& font) {
  constexpr double least_plot_mm = 28;
  constexpr double least_width_share = 0.6;
  constexpr double little_mm = 1.5;
  const figure::DrawList list = lay_out(one, font);
  const figure::DrawList wide = lay_out(two, font);
  if (list.warnings.size() > wide.warnings.size() || cut_texts(list) > cut_texts(wide))
    return false;
  if (covered_mm(list) > covered_mm(wide) + little_mm) return false;
  return std::all_of(list.plots.begin(), list.plots.end(), [&](const figure::PixelBox& plot) {
    return plot.height() >= least_plot_mm * publication::px_per_mm &&
           plot.width() >= least_width_share * one.width_px;
  });
}

}  // namespace

figure::Figure for_publication(const figure::Figure& figure, const text::Font& font) {
  figure::Figure printed = figure;
  printed.look = figure::Look::publication;
  printed.title.clear();
  const double shape = static_cast<double>(figure.height_px) / figure.width_px;
  const layout::FigureStyle style(in_columns(printed, true, shape));
  for (figure::Panel& panel : printed.panels) {
    for (figure::Series& series : panel.series) {
      series.width_px *= style.stroke;
      series.marker_size_px *= style.marker;
    }
  }
  figure::Figure one = in_columns(printed, false, shape);
  figure::Figure wide = in_columns(printed, true, shape);
  if (one.diagram) return is_narrow(*one.diagram) ? one : wide;
  return fits_in_one(one, wide, font) ? one : wide;
}

}  // namespace tribolog::render::composition
