#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <unordered_set>

#include "render/figure/draw_list.h"
#include "render/figure/figure.h"
#include "render/layout/figure_style.h"
#include "render/layout/panel_drawing.h"
#include "render/layout/polyline.h"

namespace tribolog::render::layout {

// Arrow heads on a line that show the direction of time.

namespace {

std::optional<figure::PixelPoint> pixel_of(const PanelFrame& frame, const figure::Series& series,
                                           std::size_t i) {
  if (!drawable(series.x[i], frame.x.logarithmic()) ||
      !drawable(series.y[i], frame.y.logarithmic())) {
    return std::nullopt;
  }
  return figure::PixelPoint{frame.x.pixel(series.x[i]), frame.y.pixel(series.y[i])};
}

/// The first sample at least `distance` away from sample `from`, walking by `step`; the last one
/// before a gap if there is none.
std::optional<figure::PixelPoint> walk(const PanelFrame& frame, const figure::Series& series,
                                       std::size_t from, int step, double distance) {
  const auto start = pixel_of(frame, series, from);
  std::optional<figure::PixelPoint> last;
  if (!start) return last;
  const auto count = static_cast<std::ptrdiff_t>(std::min(series.x.size(), series.y.size()));
  for (auto i = static_cast<std::ptrdiff_t>(from) + step; i >= 0 && i < count; i += step) {
    const auto here = pixel_of(frame, series, static_cast<std::size_t>(i));
    if (!here) break;
    last = here;
    if (std::hypot(here->x - start->x, here->y - start->y) >= distance) break;
  }
  return last;
}

void draw_direction_arrows(figure::DrawList& list, const PanelFrame& frame,
                           const figure::Series& series, const FigureStyle& style,
                           figure::Owner owner) {
  const std::size_t count = std::min(series.x.size(), series.y.size());
  if (count < 2) return;
  const double length = 20 * style.marker + 2.0 * series.width_px;
  const double half_width = 0.42 * length;
  for (const double share : series.direction_arrows_at) {
    if (!(share >= 0.0 && share <= 1.0)) continue;
    const auto at = static_cast<std::size_t>(std::lround(share * static_cast<double>(count - 1)));
    const auto here = pixel_of(frame, series, at);
    if (!here || !frame.plot.contains(*here)) continue;
    const auto behind = walk(frame, series, at, -1, length / 2).value_or(*here);
    const auto ahead = walk(frame, series, at, +1, length / 2).value_or(*here);
    const double dx = ahead.x - behind.x;
    const double dy = ahead.y - behind.y;
    const double norm = std::hypot(dx, dy);
    if (norm < 1e-6) continue;
    const figure::PixelPoint along{dx / norm, dy / norm};
    // A head lies on its sample; at the end of a line its tip does, at the start its base.
    const double before = at == 0 ? 0.0 : at + 1 == count ? length : length / 2;
    const figure::PixelPoint base{here->x - along.x * before, here->y - along.y * before};
    const figure::PixelPoint tip{base.x + along.x * length, base.y + along.y * length};
    list.primitives.emplace_back(
        figure::Polygon{owner,
                        {tip,
                         {base.x - along.y * half_width, base.y + along.x * half_width},
                         {base.x + along.y * half_width, base.y - along.x * half_width}},
                        series.colour});
  }
}

std::optional<figure::PixelPoint> place(const PanelFrame& frame, double x, double y) {
  if (!drawable(x, frame.x.logarithmic()) || !drawable(y, frame.y.logarithmic())) {
    return std::nullopt;
  }
  return figure::PixelPoint{frame.x.pixel(x), frame.y.pixel(y)};
}

void report_dropped(figure::DrawList& list, const PanelFrame& frame, const figure::Series& series,
                    int index, std::size_t drawn) {
  const std::size_t all = std::max(series.x.size(), series.y.size());
  if (drawn == all && all > 0) return;
  const Statement name = figure::name_of_series(series.label, static_cast<std::size_t>(index));
  if (drawn == 0) {
    list.warnings.push_back({"drawing.no_sample", {{"series", name}}});
    return;
  }
  const bool logarithmic = frame.x.logarithmic() || frame.y.logarithmic();
  const StatedValue dropped{"dropped", all - drawn};
  const StatedValue of{"all", all};
  if (logarithmic) {
    list.warnings.push_back({"drawing.samples_not_positive", {{"series", name}, dropped, of}});
  } else {
    list.warnings.push_back({"drawing.samples_not_finite", {{"series", name}, dropped, of}});
  }
}

/// Markers that would hide each other almost wholly are drawn once.
class MarkerSieve {
 public:
  MarkerSieve(double size, std::size_t count)
      : cell_(count > many ? std::max(1.0, 0.25 * size) : 0.5) {}
  bool fresh(figure::PixelPoint p) {
    const auto column = static_cast<std::int64_t>(std::floor(p.x / cell_));
    const auto row = static_cast<std::int64_t>(std::floor(p.y / cell_));
    return taken_.insert(column * 1'000'003 + row).second;
  }

 private:
  static constexpr std::size_t many = 2000;
  double cell_;
  std::unordered_set<std::int64_t> taken_;
};

}  // namespace

void draw_series(figure::DrawList& list, const PanelFrame& frame, const figure::Series& series,
                 const FigureStyle& style, int panel, int index) {
  const std::size_t count = std::min(series.x.size(), series.y.size());
  LineCollector collector(frame.plot);
  figure::Markers markers{{figure::Role::series_marker, panel, index},
                          series.marker,
                          {},
                          series.marker_size_px,
                          series.colour};
  MarkerSieve sieve(series.marker_size_px, count);
  const bool marked = series.marker != figure::Marker::none;
  std::size_t drawn = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const auto point = place(frame, series.x[i], series.y[i]);
    if (!point) {
      collector.lift();
      continue;
    }
    ++drawn;
    collector.add(*point);
    if (marked && frame.plot.grown(0.5).contains(*point) && sieve.fresh(*point)) {
      markers.centres.push_back(*point);
    }
  }
  report_dropped(list, frame, series, index, drawn);
  const figure::Owner owner{figure::Role::series, panel, index};
  if (series.style != figure::LineStyle::none) {
    const std::vector<double> dashes = figure::dash_lengths(series.style, series.width_px);
    for (auto& line : collector.take()) {
      if (line.size() == 1 && marked) continue;
      if (line.size() == 1) {  // a lone sample between gaps is a dot as wide as the line
        list.primitives.emplace_back(figure::Markers{
            owner, figure::Marker::circle, {line.front()}, 2.0 * series.width_px, series.colour});
        continue;
      }
      list.primitives.emplace_back(
          figure::Polyline{owner, std::move(line), series.width_px, series.colour, dashes});
    }
    draw_direction_arrows(list, frame, series, style,
                          {figure::Role::direction_arrow, panel, index});
  }
  if (!markers.centres.empty()) list.primitives.emplace_back(std::move(markers));
}

void draw_band(figure::DrawList& list, const PanelFrame& frame, const figure::Band& band,
               figure::Owner owner) {
  figure::Ribbon ribbon{owner, {}, {}, band.colour};
  const auto finish = [&] {
    if (ribbon.edge_a.size() > 1) list.primitives.emplace_back(ribbon);
    ribbon.edge_a.clear();
    ribbon.edge_b.clear();
  };
  const std::size_t count = std::min({band.x.size(), band.low.size(), band.high.size()});
  std::size_t dropped = 0;
  for (std::size_t i = 0; i < count; ++i) {
    auto low = place(frame, band.x[i], band.low[i]);
    auto high = place(frame, band.x[i], band.high[i]);
    if (!low || !high) {
      ++dropped;
      finish();
      continue;
    }
    for (figure::PixelPoint* p : {&*low, &*high}) {
      p->x = std::clamp(p->x, frame.plot.left, frame.plot.right);
      p->y = std::clamp(p->y, frame.plot.top, frame.plot.bottom);
    }
    constexpr double finest = 0.25;  // pixels between two points of an edge
    const bool last = i + 1 == count;
    if (!ribbon.edge_a.empty() && !last && std::abs(low->x - ribbon.edge_a.back().x) < finest) {
      ribbon.edge_a.back().y = std::max(ribbon.edge_a.back().y, low->y);
      ribbon.edge_b.back().y = std::min(ribbon.edge_b.back().y, high->y);
      continue;
    }
    ribbon.edge_a.push_back(*low);
    ribbon.edge_b.push_back(*high);
  }
  finish();
  if (dropped > 0) {
    list.warnings.push_back(
        {"drawing.band_not_finite", {{"label", band.label}, {"dropped", dropped}}});
  }
}

void draw_error_bar(figure::DrawList& list, const PanelFrame& frame, const figure::ErrorBar& bar,
                    const FigureStyle& style, figure::Owner owner) {
  const auto low = place(frame, bar.x, bar.low);
  const auto high = place(frame, bar.x, bar.high);
  if (!low || !high) {
    list.warnings.push_back({"drawing.error_bar_not_finite"});
    return;
  }
  const double half_cap = 8 * style.unit;
  const double width = 2.5 * style.stroke;
  const auto line = [&](figure::PixelPoint a, figure::PixelPoint b) {
    if (const auto visible = clipped({a, b}, frame.plot)) {
      list.primitives.emplace_back(
          figure::Polyline{owner, {visible->first, visible->second}, width, bar.colour, {}});
    }
  };
  line(*low, *high);
  line({low->x - half_cap, low->y}, {low->x + half_cap, low->y});
  line({high->x - half_cap, high->y}, {high->x + half_cap, high->y});
}

void draw_reference_line(figure::DrawList& list, const PanelFrame& frame,
                         const figure::ReferenceLine& line, const FigureStyle& style,
                         figure::Owner owner) {
  const bool vertical = line.direction == figure::ReferenceLine::Direction::vertical;
  const AxisMap& axis = vertical ? frame.x : frame.y;
  if (!drawable(line.at, axis.logarithmic())) {
    list.warnings.push_back({"drawing.reference_line_not_finite", {{"label", line.text}}});
    return;
  }
  const double at = axis.pixel(line.at);
  const figure::PixelPoint a = vertical ? figure::PixelPoint{at, frame.plot.bottom}
                                        : figure::PixelPoint{frame.plot.left, at};
  const figure::PixelPoint b =
      vertical ? figure::PixelPoint{at, frame.plot.top} : figure::PixelPoint{frame.plot.right, at};
  const double width = 2.0 * style.stroke;
  if (line.style == figure::LineStyle::none || !clipped({a, b}, frame.plot)) return;
  list.primitives.emplace_back(
      figure::Polyline{owner, {a, b}, width, line.colour, figure::dash_lengths(line.style, width)});
}

bool has_drawable_data(const figure::Panel& panel) {
  const auto good = [&](double x, double y) {
    return drawable(x, panel.x.logarithmic) && drawable(y, panel.y.logarithmic);
  };
  for (const figure::Series& one : panel.series) {
    for (std::size_t i = 0; i < std::min(one.x.size(), one.y.size()); ++i) {
      if (good(one.x[i], one.y[i])) return true;
    }
  }
  for (const figure::Band& band : panel.bands) {
    for (std::size_t i = 0; i < std::min({band.x.size(), band.low.size(), band.high.size()}); ++i) {
      if (good(band.x[i], band.low[i]) && good(band.x[i], band.high[i])) return true;
    }
  }
  return std::any_of(panel.error_bars.begin(), panel.error_bars.end(),
                     [&](const figure::ErrorBar& bar) { return good(bar.x, bar.low); }) ||
         std::any_of(panel.point_labels.begin(), panel.point_labels.end(),
                     [&](const figure::PointLabel& label) { return good(label.x, label.y); });
}

}  // namespace tribolog::render::layout
