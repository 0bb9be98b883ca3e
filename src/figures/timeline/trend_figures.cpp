#include "figures/timeline/trend_figures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <numeric>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/requirements.h"
#include "calibration/friction_speeds.h"
#include "figures/report_figure.h"
#include "figures/timeline/history_axes.h"
#include "history/joint_trend.h"
#include "render/figure/figure.h"
#include "statistics/distributions.h"
#include "wording/axis_scale.h"
#include "wording/number_text.h"
#include "wording/rounding.h"
#include "wording/tr.h"
#include "wording/words.h"

namespace tribolog::figures::timeline {

// Its two panels, over one axis of dates.

namespace {

namespace colour = render::figure::palette;
using history::FoundChange;
using history::HistoryPoint;
using history::LeftOut;
using history::QuantityTrend;
using wording::tr;
using wording::tr_count;

constexpr std::size_t many_points = 40;

std::string name_of(const history::QuantityTrend& trend) {
  return quantity_words(trend.name, trend.words);
}

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
  panel.x.title = tr("measured on (UTC)");
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
  band.label = tr("reference ± 2 standard deviations of a calibration");
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
    if (with_text) line.text = text;
    line.colour = c;
    panel.reference_lines.push_back(std::move(line));
  };
  for (const history::FoundChange& change : trend.changes) {
    const std::string& visible = change.is_slow ? change.alarm : change.from;
    add_line(visible, tr("visible from {date}", {{"date", wording::date_of(visible)}}),
             colour::vermilion);
    if (change.is_slow) continue;
    if (change.alarm != change.from) {
      add_line(change.alarm, tr("alarm {date}", {{"date", wording::date_of(change.alarm)}}),
               colour::grey);
    }
    if (!change.back.empty()) {
      add_line(change.back, tr("back from {date}", {{"date", wording::date_of(change.back)}}),
               colour::green);
    }
  }
}

/// Along the line of a slow drift.
void add_drift(const history::QuantityTrend& trend, const wording::AxisScale& scale,
               render::figure::Panel& panel) {
  for (const history::FoundChange& change : trend.changes) {
    if (!change.is_slow) continue;
    panel.series.push_back(
        line(tr("drift"), {day_of(change.from), day_of(trend.points.back().measured_at)},
             {scale(change.drift_start), scale(change.drift_start + change.size.value)},
             colour::vermilion, 2.5, render::figure::LineStyle::solid));
  }
}

/// Those that would squash the others on the axis: whatever was left out, and where no change was
/// found, a single calibration far from the others, or one in eight.
std::vector<bool> far_off(const history::QuantityTrend& trend) {
  constexpr double squashed = 3;  // The axis would grow so many times.
  const auto extent_without = [&](const std::vector<bool>& left, std::size_t further) {
    wording::Extent extent;
    for (std::size_t i = 0; i < trend.points.size(); ++i) {
      if (!left[i] && i != further)
        extent.add({trend.points[i].estimate.low, trend.points[i].estimate.high});
    }
    return extent;
  };
  std::vector<bool> off(trend.points.size());
  std::size_t used = 0;
  for (std::size_t i = 0; i < off.size(); ++i) {
    off[i] = trend.points[i].left_out != history::LeftOut::none;
    if (!off[i]) ++used;
  }
  constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
  constexpr std::size_t fewest = 4;
  if (trend.changes.empty() && used >= fewest) {
    constexpr std::size_t one_in = 8;
    for (std::size_t round = 0; round < std::max<std::size_t>(1, used / one_in); ++round) {
      std::size_t furthest = none;
      double least = extent_without(off, none).span() / squashed;
      for (std::size_t i = 0; i < off.size(); ++i) {
        const double rest = off[i] ? least : extent_without(off, i).span();
        if (rest < least) {
          least = rest;
          furthest = i;
        }
      }
      if (furthest == none) break;
      off[furthest] = true;
    }
  }
  const wording::Extent rest = extent_without(off, none);
  if (rest.empty) return std::vector<bool>(off.size());
  for (std::size_t i = 0; i < off.size(); ++i) {
    wording::Extent with = rest;
    with.add(trend.points[i].estimate.value);
    off[i] = off[i] && with.span() > squashed * rest.span();
  }
  return off;
}

/// The axis holds what is not far off, and leaves room above for the texts of the marked dates.
/// What is far off stands at the edge with an arrow and its value; the series keep it as it is.
void set_value_axis(const history::QuantityTrend& trend, const wording::AxisScale& scale,
                    render::figure::Panel& panel) {
  const std::vector<bool> off = far_off(trend);
  const bool has_far = std::find(off.begin(), off.end(), true) != off.end();
  if (!has_far && trend.changes.empty()) return;
  constexpr double above = 0.16;
  constexpr double margin = 0.08;
  constexpr int digits = 4;
  wording::Extent extent;
  bool is_band_wide = false;  // The scatter holds what is far off.
  for (std::size_t i = 0; i < off.size(); ++i) {
    const statistics::Estimate& e = trend.points[i].estimate;
    if (!off[i]) extent.add({scale(e.low), scale(e.high)});
    is_band_wide = is_band_wide || (off[i] && trend.points[i].left_out == history::LeftOut::none);
  }
  for (const render::figure::Band& band : panel.bands) {
    if (is_band_wide) break;
    extent.add(band.low);
    extent.add(band.high);
  }
  for (const render::figure::Series& s : panel.series) {
    if (s.style != render::figure::LineStyle::none) extent.add(s.y);
  }
  panel.y.maximum = extent.high + (trend.changes.empty() ? margin : above) * extent.span();
  if (!has_far) return;
  panel.y.minimum = extent.low - margin * extent.span();
  for (std::size_t i = 0; i < off.size(); ++i) {
    if (!off[i]) continue;
    const double value = scale(trend.points[i].estimate.value);
    const bool is_above = value > extent.high;
    render::figure::PointLabel label;
    label.x = day_of(trend.points[i].measured_at);
    constexpr double inside = 0.03;  // of the span, so that the mark is whole
    label.y = is_above ? present(panel.y.maximum) - inside * extent.span()
                       : present(panel.y.minimum) + inside * extent.span();
    label.text = (is_above ? "↑ " : "↓ ") +
                 wording::with_unit(trend.points[i].estimate.value, scale, digits);
    label.colour = trend.points[i].left_out != history::LeftOut::none ? colour::grey : colour::blue;
    label.marker = render::figure::Marker::cross;
    add_visible(panel, std::move(label));
  }
  for (render::figure::Series& s : panel.series) s.is_marked_at_edge = true;
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
  panel.y.title = wording::axis_title(name_of(trend), scale, trend.unit);
  set_time_axis(trend, panel);
  add_reference(trend, scale, panel);
  const bool is_corrected = is_visibly_corrected(trend);
  const std::size_t all = trend.points.size();
  render::figure::Series learned =
      marks(is_corrected ? tr("the first, baseline only (at one temperature)")
                         : tr("the first, baseline only"),
            colour::sky_blue, render::figure::Marker::square, all);
  render::figure::Series judged =
      marks(is_corrected ? tr("calibration, 95 % interval (at one temperature)")
                         : tr("calibration, 95 % interval"),
            colour::blue, render::figure::Marker::circle, all);
  render::figure::Series as_measured =
      marks(tr("as measured"), colour::orange, render::figure::Marker::plus, all);
  render::figure::Series left =
      marks(tr("left out"), colour::grey, render::figure::Marker::cross, all);
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
  set_value_axis(trend, scale, panel);
  return panel;
}

/// Both sums of the chart and their limit.
render::figure::Panel sum_panel(const history::QuantityTrend& trend) {
  render::figure::Panel panel;
  panel.y.title = tr("CUSUM [standard deviations]");
  set_time_axis(trend, panel);
  render::figure::Series above = line(tr("C^{{+}}, risen"), {}, {}, colour::blue, 3.0);
  render::figure::Series below =
      line(tr("−C^{{−}}, fallen"), {}, {}, colour::orange, 3.0, render::figure::LineStyle::dash);
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
    line.text =
        tr("limit {limit}", {{"limit", fmt::format("{}{:.1f}", side > 0 ? "" : "−", trend.limit)}});
    line.colour = colour::vermilion;
    panel.reference_lines.push_back(std::move(line));
  }
  mark_changes(trend, false, panel);
  return panel;
}

using wording::AxisScale;

std::string drift_words(const history::FoundChange& change, const std::string& size) {
  const std::initializer_list<StatedValue> values{{"change", size},
                                                  {"first_date", wording::date_of(change.from)},
                                                  {"visible_date", wording::date_of(change.alarm)}};
  return change.direction > 0
             ? tr("slowly risen by {change} since {first_date}, visible from {visible_date}",
                  values)
             : tr("slowly fallen by {change} since {first_date}, visible from {visible_date}",
                  values);
}

std::string shift_words(const history::FoundChange& change, const std::string& size) {
  const std::initializer_list<StatedValue> values{{"change", size},
                                                  {"visible_date", wording::date_of(change.from)},
                                                  {"alarm_date", wording::date_of(change.alarm)},
                                                  {"back_date", wording::date_of(change.back)}};
  if (change.back.empty()) {
    return change.direction > 0
               ? tr("risen by {change}, visible from {visible_date}, alarm {alarm_date}", values)
               : tr("fallen by {change}, visible from {visible_date}, alarm {alarm_date}", values);
  }
  return change.direction > 0
             ? tr("risen by {change}, visible from {visible_date}, alarm {alarm_date}, back from "
                  "{back_date}",
                  values)
             : tr("fallen by {change}, visible from {visible_date}, alarm {alarm_date}, back from "
                  "{back_date}",
                  values);
}

std::string change_words(const history::FoundChange& change, const wording::AxisScale& scale) {
  const std::string size = change.percent ? fmt::format("{:.2g} %", std::abs(*change.percent))
                                          : wording::with_unit(std::abs(change.size.value),
                                                               {scale.factor, scale.unit}, 2);
  return change.is_slow ? drift_words(change, size) : shift_words(change, size);
}

/// What came of it, as a sentence.
std::string finding(const history::QuantityTrend& trend, const wording::AxisScale& scale) {
  const std::size_t used = trend.count(history::LeftOut::none);
  const auto n = static_cast<std::int64_t>(used);
  const std::initializer_list<StatedValue> values{{"quantity", name_of(trend)},
                                                  {"calibrations", used}};
  if (trend.state == history::TrendState::too_few) {
    return tr_count(
        n, "{quantity}: {calibrations} usable calibration, too few to say anything yet.",
        "{quantity}: {calibrations} usable calibrations, too few to say anything yet.", values);
  }
  if (trend.state == history::TrendState::apart) {
    std::vector<std::string> dates;
    for (const history::FoundApart& one : trend.apart) dates.push_back(wording::date_of(one.at));
    return tr("{quantity}: no lasting change visible; far from the others on {dates}.",
              {{"quantity", name_of(trend)}, {"dates", wording::listed(dates)}});
  }
  if (trend.changes.empty()) {
    return tr_count(n, "{quantity}: no change visible over {calibrations} calibration.",
                    "{quantity}: no change visible over {calibrations} calibrations.", values);
  }
  std::vector<std::string> changes;
  for (const history::FoundChange& change : trend.changes) {
    changes.push_back(change_words(change, scale));
  }
  return fmt::format("{}: {}.", name_of(trend), fmt::join(changes, "; "));
}

std::string caption_of(const history::QuantityTrend& trend, const wording::AxisScale& scale) {
  std::string caption = finding(trend, scale);
  if (!trend.reference) return caption;
  const std::size_t members = trend.reference->members;
  const double half_width = statistics::normal_975 * std::sqrt(trend.reference->level_variance);
  const std::initializer_list<StatedValue> values{
      {"reference", wording::with_interval(
                        statistics::symmetric_estimate(trend.reference->level, half_width), scale)},
      {"calibrations", members}};
  return caption + " " +
         tr_count(static_cast<std::int64_t>(members),
                  "Reference {reference} from {calibrations} calibration.",
                  "Reference {reference} from {calibrations} calibrations.", values);
}

std::string how_to_read(const history::QuantityTrend& trend) {
  std::string words = tr(
      "Above, points that leave the band on one side for good are a change; single ones are not.");
  words += " ";
  if (is_visibly_corrected(trend)) {
    words += tr("All except the plus signs are corrected to one temperature.");
    words += " ";
  }
  const std::vector<bool> off = far_off(trend);
  if (std::find(off.begin(), off.end(), true) != off.end()) {
    words += tr("An arrow with a value stands for a calibration beyond the axis.");
    words += " ";
  }
  if (trend.judged > 0) {
    words +=
        tr("Below, the alarm is raised when the sum reaches its limit; the change began where the "
           "climb did. After the alarm the sum is drawn up to twice the limit.");
  }
  return words;
}

ReportFigure figure_of(const history::QuantityTrend& trend, std::string id) {
  wording::Extent extent;
  const std::vector<bool> off = far_off(trend);
  for (std::size_t i = 0; i < off.size(); ++i) {
    const statistics::Estimate& e = trend.points[i].estimate;
    if (!off[i]) extent.add({e.low, e.high});
  }
  const wording::AxisScale scale = quantity_axis(trend.unit, extent.largest());
  ReportFigure out;
  out.id = std::move(id);
  out.title = tr("{quantity} over time", {{"quantity", name_of(trend)}});
  out.stage = "trend";
  out.figure.panels.push_back(trend_panel(trend, scale));
  if (trend.judged > 0) out.figure.panels.push_back(sum_panel(trend));
  out.figure.panels_share_x = true;
  out.figure.height_px = trend.judged > 0 ? 1200 : 750;
  out.figure.id = out.id;
  out.figure.title = out.title;
  out.caption = caption_of(trend, scale);
  out.how_to_read = how_to_read(trend);
  out.alt = tr("{quantity} over time from {first_date} to {last_date}.",
               {{"quantity", name_of(trend)},
                {"first_date", wording::date_of(trend.points.front().measured_at)},
                {"last_date", wording::date_of(trend.points.back().measured_at)}}) +
            " " + out.caption;
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

// Friction at all speeds in one picture.

bool is_friction(const history::QuantityTrend& trend) {
  return calibration::speed_of_friction(trend.name).has_value();
}

/// What stands for 100 %: of a slow drift where it began. Nothing where nothing was used.
std::optional<double> level_of(const history::QuantityTrend& trend) {
  for (const FoundChange& change : trend.changes) {
    if (change.is_slow) return change.drift_start;
  }
  if (trend.reference) return trend.reference->level;
  for (const HistoryPoint& p : trend.points) {
    if (p.left_out == LeftOut::none) return p.estimate.value;
  }
  return std::nullopt;
}

/// Percent of the reference above it.
double percent_above(double value, double level) { return 100 * (value / level - 1); }

struct FrictionLines {
  render::figure::Panel panel;
  std::string first_at, last_at;
  wording::Extent latest;  ///< Percent.
  std::size_t speeds{};
};

void add_speed(const history::QuantityTrend& trend, FrictionLines& lines) {
  constexpr std::array colours{colour::purple, colour::blue,      colour::sky_blue, colour::green,
                               colour::orange, colour::vermilion, colour::black};
  constexpr std::array shapes{render::figure::Marker::circle, render::figure::Marker::square,
                              render::figure::Marker::triangle, render::figure::Marker::diamond};
  const std::optional<double> level = level_of(trend);
  if (!level || !(*level > 0)) return;
  const std::size_t k = lines.speeds;
  render::figure::Series series =
      line(wording::with_unit(
               fmt::format("{:g}", present(calibration::speed_of_friction(trend.name))), "rad/s"),
           {}, {}, colours[k % colours.size()], 2.0, render::figure::LineStyle::solid);
  series.marker = shapes[k % shapes.size()];
  series.marker_size_px = trend.points.size() > many_points ? 6.0 : 10.0;
  for (const HistoryPoint& p : trend.points) {
    if (p.left_out != LeftOut::none) continue;
    const double day = day_of(p.measured_at);
    const double by = p.corrected.value_or(p.estimate.value) - p.estimate.value;
    add(series, day, percent_above(p.estimate.value + by, *level));
    render::figure::ErrorBar bar{day, percent_above(p.estimate.low + by, *level),
                                 percent_above(p.estimate.high + by, *level)};
    bar.colour = series.colour;
    lines.panel.error_bars.push_back(bar);
    if (lines.first_at.empty() || p.measured_at < lines.first_at) lines.first_at = p.measured_at;
    lines.last_at = std::max(lines.last_at, p.measured_at);
  }
  if (series.y.empty()) return;
  lines.latest.add({series.y.back()});
  ++lines.speeds;
  add_visible(lines.panel, std::move(series));
}

std::string signed_percent(double percent) {
  return wording::with_minus_sign(fmt::format("{:+.1f}", percent)) + "\u00a0%";
}

/// @return nothing where no speed was used.
std::optional<ReportFigure> friction_figure(const history::JointTrend& trend, std::string id) {
  FrictionLines lines;
  for (const history::QuantityTrend& q : trend.quantities) {
    if (is_friction(q)) add_speed(q, lines);
  }
  if (lines.speeds == 0) return std::nullopt;
  lines.panel.x.title = tr("measured on (UTC)");
  lines.panel.x.dates = true;
  const double first = day_of(lines.first_at);
  const double last = day_of(lines.last_at);
  const double margin = std::max(0.03 * (last - first), 1.5);
  lines.panel.x.minimum = first - margin;
  lines.panel.x.maximum = last + margin;
  lines.panel.y.title = tr("friction above its reference [%]");
  lines.panel.reference_lines.push_back(
      {render::figure::ReferenceLine::Direction::horizontal, 0, tr("reference")});
  ReportFigure out;
  out.id = std::move(id);
  out.title = tr("Friction over time");
  out.stage = "trend";
  out.figure.id = out.id;
  out.figure.title = out.title;
  out.figure.height_px = 750;
  const std::initializer_list<StatedValue> values{{"speeds", lines.speeds},
                                                  {"date", wording::date_of(lines.last_at)},
                                                  {"lowest", signed_percent(lines.latest.low)},
                                                  {"highest", signed_percent(lines.latest.high)}};
  out.caption = tr_count(static_cast<std::int64_t>(lines.speeds),
                         "Friction at {speeds} speed against its reference: {lowest} on {date}.",
                         "Friction at {speeds} speeds against their references: {lowest} to "
                         "{highest} on {date}.",
                         values);
  out.how_to_read =
      tr("Each line is a speed of the motor. Wear, a lubricant that ages and a warm day move all "
         "lines together or one end of them; a "
         "torque constant that changed moves all by the same share. Bars are 95 % intervals.");
  out.alt = tr("Friction from {first_date} to {last_date}.",
               {{"first_date", wording::date_of(lines.first_at)},
                {"last_date", wording::date_of(lines.last_at)}}) +
            " " + out.caption;
  out.figure.panels.push_back(std::move(lines.panel));
  return out;
}

}  // namespace

std::vector<ReportFigure> trend_figures(const std::vector<history::JointTrend>& trends) {
  std::vector<ReportFigure> all;
  for (std::size_t j = 0; j < trends.size(); ++j) {
    const std::vector<history::QuantityTrend>& quantities = trends[j].quantities;
    if (auto friction = friction_figure(trends[j], fmt::format("trend-{}-friction", j + 1))) {
      all.push_back(std::move(*friction));
    }
    for (const std::size_t q : by_weight(quantities)) {
      if (quantities[q].points.empty() || is_friction(quantities[q])) continue;
      all.push_back(figure_of(quantities[q], fmt::format("trend-{}-{}", j + 1, q + 1)));
    }
  }
  return all;
}

}  // namespace tribolog::figures::timeline
