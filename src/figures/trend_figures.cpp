#include "figures/trend_figures.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "base/requirements.h"
#include "figures/history_axes.h"
#include "figures/report_figure.h"
#include "history/joint_trend.h"
#include "render/figure/figure.h"
#include "statistics/distributions.h"
#include "wording/axis_scale.h"
#include "wording/number_text.h"

namespace tribolog::figures {

// Its two panels, over one axis of dates.

namespace {

namespace colour = render::figure::palette;
using history::FoundChange;
using history::HistoryPoint;
using history::LeftOut;
using history::QuantityTrend;

constexpr std::size_t many_points = 40;

render::figure::Series marks(const std::string& label, render::figure::Colour c,
                             render::figure::Marker marker, std::size_t all) {
  render::figure::Series series;
  series.label = label;
  series.colour = c;
  series.style = render::figure::LineStyle::none;
  series.marker = marker;
  series.marker_size_px = all > many_points ? 8.0 : 13.0;
  return series;
}

void add(render::figure::Series& series, double x, double y) {
  series.x.push_back(x);
  series.y.push_back(y);
}

/// Days, so that no first or last point lies on the frame.
double margin_of(const history::QuantityTrend& trend) {
  const double span =
      day_of(trend.points.back().measured_at) - day_of(trend.points.front().measured_at);
  return std::max(0.03 * span, 1.5);
}

void set_time_axis(const history::QuantityTrend& trend, render::figure::Panel& panel) {
  panel.x.title = "measured on (UTC)";
  panel.x.dates = true;
  panel.x.minimum = day_of(trend.points.front().measured_at) - margin_of(trend);
  panel.x.maximum = day_of(trend.points.back().measured_at) + margin_of(trend);
}

void add_reference(const history::QuantityTrend& trend, const wording::AxisScale& scale,
                   render::figure::Panel& panel) {
  if (!trend.reference) return;
  constexpr double wide = 2;
  const double level = trend.reference->level;
  const double scatter = wide * trend.reference->scatter();
  render::figure::Band band;
  band.label = "reference ± 2 standard deviations of a calibration";
  band.x = {present(panel.x.minimum), present(panel.x.maximum)};
  band.low = {scale(level - scatter), scale(level - scatter)};
  band.high = {scale(level + scatter), scale(level + scatter)};
  band.colour = {colour::green.red, colour::green.green, colour::green.blue, 45};
  panel.bands.push_back(std::move(band));
  panel.series.push_back(line("", {present(panel.x.minimum), present(panel.x.maximum)},
                              {scale(level), scale(level)}, colour::green, 2.5,
                              render::figure::LineStyle::dash));
}

/// Vertical lines at the dates of the changes.
void mark_changes(const history::QuantityTrend& trend, bool with_text,
                  render::figure::Panel& panel) {
  const auto add_line = [&](const std::string& date, const std::string& text,
                            render::figure::Colour c) {
    render::figure::ReferenceLine line;
    line.at = day_of(date);
    if (with_text) line.text = text + " " + date_of(date);
    line.colour = c;
    panel.reference_lines.push_back(std::move(line));
  };
  for (const history::FoundChange& change : trend.changes) {
    if (change.is_slow) {
      add_line(change.alarm, "visible from", colour::vermilion);
      continue;
    }
    add_line(change.from, "visible from", colour::vermilion);
    if (change.alarm != change.from) add_line(change.alarm, "alarm", colour::grey);
    if (!change.back.empty()) add_line(change.back, "back from", colour::green);
  }
}

/// Along the line of a slow drift.
void add_drift(const history::QuantityTrend& trend, const wording::AxisScale& scale,
               render::figure::Panel& panel) {
  for (const history::FoundChange& change : trend.changes) {
    if (!change.is_slow) continue;
    panel.series.push_back(
        line("drift", {day_of(change.from), day_of(trend.points.back().measured_at)},
             {scale(change.drift_start), scale(change.drift_start + change.size.value)},
             colour::vermilion, 2.5, render::figure::LineStyle::solid));
  }
}

/// For the texts of the marked dates.
void leave_room_above(render::figure::Panel& panel) {
  constexpr double share = 0.16;
  wording::Extent extent;
  for (const render::figure::ErrorBar& bar : panel.error_bars) extent.add({bar.low, bar.high});
  for (const render::figure::Series& s : panel.series) extent.add(s.y);
  panel.y.maximum = extent.high + share * extent.span();
}

/// Whether temperature's effect is more than what chance makes of none; only then are values shown
/// as brought to one temperature.
bool is_visibly_corrected(const history::QuantityTrend& trend) {
  constexpr double clear = 2;
  return trend.temperature == history::TemperatureUse::corrected && trend.reference &&
         std::abs(trend.reference->slope_per_K) >
             clear * std::sqrt(trend.reference->slope_variance);
}

/// Values with intervals, the reference, what was left out, the dates of changes.
/// @param trend with at least one point.
render::figure::Panel trend_panel(const history::QuantityTrend& trend,
                                  const wording::AxisScale& scale) {
  render::figure::Panel panel;
  panel.y.title = wording::axis_title(trend.words, scale, trend.unit);
  set_time_axis(trend, panel);
  add_reference(trend, scale, panel);
  const bool is_corrected = is_visibly_corrected(trend);
  const std::size_t all = trend.points.size();
  const char* const at = is_corrected ? " (at one temperature)" : "";
  render::figure::Series learned = marks(std::string("the first, only learned from") + at,
                                         colour::sky_blue, render::figure::Marker::square, all);
  render::figure::Series judged = marks(std::string("calibration, 95 % interval") + at,
                                        colour::blue, render::figure::Marker::circle, all);
  render::figure::Series as_measured =
      marks("as measured", colour::orange, render::figure::Marker::plus, all);
  render::figure::Series left = marks("left out", colour::grey, render::figure::Marker::cross, all);
  for (const history::HistoryPoint& p : trend.points) {
    const double day = day_of(p.measured_at);
    if (p.left_out != history::LeftOut::none) {
      add(left, day, scale(p.estimate.value));
      continue;
    }
    const double value = is_corrected ? p.corrected.value_or(p.estimate.value) : p.estimate.value;
    const double by = value - p.estimate.value;
    render::figure::ErrorBar bar{day, scale(p.estimate.low + by), scale(p.estimate.high + by)};
    bar.colour = p.chart.is_judged ? colour::blue : colour::sky_blue;
    panel.error_bars.push_back(bar);
    add(p.chart.is_judged ? judged : learned, day, scale(value));
    if (is_corrected) add(as_measured, day, scale(p.estimate.value));
  }
  for (render::figure::Series* s : {&left, &learned, &judged, &as_measured}) {
    add_visible(panel, std::move(*s));
  }
  add_drift(trend, scale, panel);
  mark_changes(trend, true, panel);
  if (!trend.changes.empty()) leave_room_above(panel);
  return panel;
}

/// Both sums of the chart and their limit.
render::figure::Panel sum_panel(const history::QuantityTrend& trend) {
  render::figure::Panel panel;
  panel.y.title = "CUSUM [standard deviations]";
  set_time_axis(trend, panel);
  render::figure::Series above = line("C^{+}, risen", {}, {}, colour::blue, 3.0);
  render::figure::Series below =
      line("−C^{−}, fallen", {}, {}, colour::orange, 3.0, render::figure::LineStyle::dash);
  for (render::figure::Series* s : {&above, &below}) {
    s->marker = render::figure::Marker::circle;
    s->marker_size_px = trend.points.size() > many_points ? 5.0 : 8.0;
  }
  for (const history::HistoryPoint& p : trend.points) {
    if (p.left_out != history::LeftOut::none || !p.chart.is_judged) continue;
    const double day = day_of(p.measured_at);
    add(above, day, p.chart.above);
    add(below, day, -p.chart.below);
  }
  add_visible(panel, std::move(above));
  add_visible(panel, std::move(below));
  for (const double side : {1.0, -1.0}) {
    render::figure::ReferenceLine line;
    line.direction = render::figure::ReferenceLine::Direction::horizontal;
    line.at = side * trend.limit;
    line.text = fmt::format("limit {}{:.1f}", side > 0 ? "" : "−", trend.limit);
    line.colour = colour::vermilion;
    panel.reference_lines.push_back(std::move(line));
  }
  mark_changes(trend, false, panel);
  return panel;
}

using wording::AxisScale;

std::string change_words(const history::FoundChange& change, const wording::AxisScale& scale) {
  const std::string size = change.percent ? fmt::format("{:.2g} %", std::abs(*change.percent))
                                          : wording::with_unit(std::abs(change.size.value),
                                                               {scale.factor, scale.unit}, 2);
  if (change.is_slow) {
    return fmt::format("slowly {} by {} since {}, visible from {}",
                       change.direction > 0 ? "risen" : "fallen", size, date_of(change.from),
                       date_of(change.alarm));
  }
  std::string words =
      fmt::format("{} by {}, visible from {}, alarm {}", change.direction > 0 ? "risen" : "fallen",
                  size, date_of(change.from), date_of(change.alarm));
  if (!change.back.empty()) words += ", back from " + date_of(change.back);
  return words;
}

std::string caption_of(const history::QuantityTrend& trend, const wording::AxisScale& scale) {
  const std::size_t used = trend.count(history::LeftOut::none);
  std::string caption = trend.words + ": ";
  if (trend.state == history::TrendState::too_few) {
    caption += fmt::format("{} that can be used, too few to say anything yet",
                           wording::counted(used, "calibration"));
  } else if (trend.changes.empty()) {
    caption += fmt::format("no change visible over {}", wording::counted(used, "calibration"));
  } else {
    std::vector<std::string> changes;
    for (const history::FoundChange& change : trend.changes)
      changes.push_back(change_words(change, scale));
    for (std::size_t k = 0; k < changes.size(); ++k) caption += (k > 0 ? "; " : "") + changes[k];
  }
  if (trend.reference) {
    caption +=
        fmt::format(". Reference {} from {}",
                    wording::with_interval(
                        statistics::symmetric_estimate(
                            trend.reference->level,
                            statistics::normal_975 * std::sqrt(trend.reference->level_variance)),
                        scale),
                    wording::counted(trend.reference->members, "calibration"));
  }
  return caption + ".";
}

ReportFigure figure_of(const history::QuantityTrend& trend, std::string id) {
  wording::Extent extent;
  for (const history::HistoryPoint& p : trend.points) {
    extent.add(p.estimate.low);
    extent.add(p.estimate.high);
  }
  const wording::AxisScale scale = quantity_axis(trend.unit, extent.largest());
  ReportFigure out;
  out.id = std::move(id);
  out.title = trend.words + " over time";
  out.stage = "trend";
  out.figure.panels.push_back(trend_panel(trend, scale));
  if (trend.judged > 0) out.figure.panels.push_back(sum_panel(trend));
  out.figure.panels_share_x = true;
  out.figure.height_px = trend.judged > 0 ? 1200 : 750;
  out.figure.id = out.id;
  out.figure.title = out.title;
  out.caption = caption_of(trend, scale);
  out.how_to_read =
      "Above, points that leave the band to one side for good are a change; single ones are not. ";
  if (is_visibly_corrected(trend)) {
    out.how_to_read += "All but the plus signs are brought to one temperature. ";
  }
  if (trend.judged > 0) {
    out.how_to_read +=
        "Below, a sum that climbs to its limit is the alarm; the change began where the climb did. "
        "Behind the "
        "alarm it is drawn up to twice the limit.";
  }
  out.alt = fmt::format("{} over time from {} to {}. {}", trend.words,
                        date_of(trend.points.front().measured_at),
                        date_of(trend.points.back().measured_at), out.caption);
  return out;
}

/// Those with a change that stands first.
std::vector<std::size_t> by_weight(const std::vector<history::QuantityTrend>& quantities) {
  std::vector<std::size_t> order(quantities.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return quantities[a].state > quantities[b].state;
  });
  return order;
}

}  // namespace

std::vector<ReportFigure> trend_figures(const std::vector<history::JointTrend>& trends) {
  std::vector<ReportFigure> all;
  for (std::size_t j = 0; j < trends.size(); ++j) {
    const std::vector<history::QuantityTrend>& quantities = trends[j].quantities;
    for (const std::size_t q : by_weight(quantities)) {
      if (quantities[q].points.empty()) continue;
      all.push_back(figure_of(quantities[q], fmt::format("trend-{}-{}", j + 1, q + 1)));
    }
  }
  return all;
}

}  // namespace tribolog::figures
