#include "figures/timeline/comparison_figures.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

#include "figures/report_figure.h"
#include "figures/timeline/history_axes.h"
#include "wording/number_text.h"
#include "wording/tr.h"

namespace tribolog::figures::timeline {
namespace {

using calibration::RecordedFriction;
using calibration::RecordedLoop;
using history::Comparison;
using wording::AxisScale;
using wording::tr;
using wording::tr_count;

/// How the first and the second are drawn in every figure.
struct Look {
  std::string label;
  render::figure::Colour colour;
  render::figure::Marker marker;
  render::figure::LineStyle style;
};

std::vector<Look> looks_of(const history::Comparison& c) {
  std::vector<std::string> dates;
  for (const calibration::Entry* e : {&c.first, &c.second}) {
    dates.push_back(wording::date_of(e->facts.measured_at));
  }
  if (dates[0] == dates[1]) {
    dates = {tr("first of {date}", {{"date", dates[0]}}),
             tr("second of {date}", {{"date", dates[1]}})};
  }
  return {{dates[0], render::figure::palette::blue, render::figure::Marker::circle,
           render::figure::LineStyle::solid},
          {dates[1], render::figure::palette::vermilion, render::figure::Marker::diamond,
           render::figure::LineStyle::dash}};
}

ReportFigure empty_figure(const char* id, const std::string& title) {
  ReportFigure out;
  out.id = id;
  out.title = title;
  out.stage = "diff";
  out.figure.id = out.id;
  out.figure.title = out.title;
  return out;
}

double mean_size(const std::vector<double>& values) {
  double sum = 0;
  for (const double v : values) sum += std::abs(v) / static_cast<double>(values.size());
  return sum;
}

/// The runs of one direction, by speed: between the two lies a jump that nobody measured.
void add_friction(const calibration::RecordedFriction& curve, int direction, const Look& look,
                  const wording::AxisScale& scale, render::figure::Panel& panel) {
  std::vector<std::size_t> order;
  for (std::size_t k = 0; k < curve.speed_rad_s.size(); ++k) {
    if (direction * curve.speed_rad_s[k] > 0) order.push_back(k);
  }
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return curve.speed_rad_s[a] < curve.speed_rad_s[b];
  });
  // Both directions have one entry in the legend.
  const bool is_labelled =
      std::any_of(panel.series.begin(), panel.series.end(),
                  [&](const render::figure::Series& s) { return s.marker == look.marker; });
  render::figure::Series series =
      line(is_labelled ? "" : look.label, {}, {}, look.colour, 3.0, look.style);
  series.marker = look.marker;
  series.marker_size_px = 11;
  for (const std::size_t k : order) {
    series.x.push_back(curve.speed_rad_s[k]);
    series.y.push_back(scale(curve.friction_Nm[k]));
    if (!std::isfinite(curve.half_width_Nm[k])) continue;
    panel.error_bars.push_back({curve.speed_rad_s[k],
                                scale(curve.friction_Nm[k] - curve.half_width_Nm[k]),
                                scale(curve.friction_Nm[k] + curve.half_width_Nm[k]), look.colour});
  }
  add_visible(panel, std::move(series));
}

std::string run_count(const calibration::RecordedFriction& curve) {
  const std::size_t runs = curve.speed_rad_s.size();
  return tr_count(static_cast<std::int64_t>(runs), "{runs} run", "{runs} runs", {{"runs", runs}});
}

std::optional<ReportFigure> friction_figure(const history::Comparison& c,
                                            const calibration::RecordedFriction& first,
                                            const calibration::RecordedFriction& second) {
  if (first.speed_rad_s.empty() || second.speed_rad_s.empty()) return std::nullopt;
  wording::Extent extent;
  extent.add(first.friction_Nm);
  extent.add(second.friction_Nm);
  const wording::AxisScale scale = wording::prefixed("N·m", extent.largest());
  ReportFigure out = empty_figure("diff-friction", tr("Friction over speed"));
  render::figure::Panel panel;
  panel.x.title = tr("motor speed dφ/dt [rad/s]");
  panel.y.title = wording::axis_title(tr("friction T_{{f}}"), scale);
  const std::vector<Look> looks = looks_of(c);
  for (const auto& [curve, look] : {std::pair{&first, &looks[0]}, std::pair{&second, &looks[1]}}) {
    for (const int direction : {-1, 1}) add_friction(*curve, direction, *look, scale, panel);
  }
  out.figure.panels = {std::move(panel)};
  out.caption =
      tr("Friction of the constant-speed runs: {first_runs} of {first_calibration} and "
         "{second_runs} of {second_calibration}.",
         {{"first_runs", run_count(first)},
          {"first_calibration", looks[0].label},
          {"second_runs", run_count(second)},
          {"second_calibration", looks[1].label}});
  out.how_to_read =
      tr("A curve moved away from zero on both sides means higher Coulomb friction; a steeper one "
         "means more viscous friction, as with colder or thicker grease. Bars are 95 % intervals "
         "of the torque.");
  out.alt =
      tr("Friction over motor speed of both calibrations; mean size {first_friction} and "
         "{second_friction}.",
         {{"first_friction", wording::with_unit(mean_size(first.friction_Nm), scale, 3)},
          {"second_friction", wording::with_unit(mean_size(second.friction_Nm), scale, 3)}});
  return out;
}

double span_of(const std::vector<double>& values) { return wording::extent_of(values).span(); }

std::optional<ReportFigure> loop_figure(const history::Comparison& c,
                                        const std::vector<calibration::RecordedLoop>& first,
                                        const std::vector<calibration::RecordedLoop>& second) {
  if (first.empty() || second.empty()) return std::nullopt;
  const calibration::RecordedLoop& a = first.front();
  const calibration::RecordedLoop& b = second.front();
  wording::Extent angle;
  wording::Extent torque;
  for (const calibration::RecordedLoop* loop : {&a, &b}) {
    angle.add(loop->from_centre_rad);
    torque.add(loop->torque_Nm);
  }
  const wording::AxisScale x = wording::prefixed("rad", angle.largest());
  const wording::AxisScale y = wording::levelled("N·m", torque);
  ReportFigure out = empty_figure("diff-loop", tr("Hysteresis loops"));
  render::figure::Panel panel;
  panel.x.title = wording::axis_title(tr("joint angle from the loop's centre"), x);
  panel.y.title = wording::axis_title(tr("driving torque T"), y, "N·m");
  const std::vector<Look> looks = looks_of(c);
  for (const auto& [loop, look] : {std::pair{&a, &looks[0]}, std::pair{&b, &looks[1]}}) {
    std::vector<double> q = shown(loop->from_centre_rad, x);
    std::vector<double> t = shown(loop->torque_Nm, y);
    q.push_back(q.front());
    t.push_back(t.front());
    add_visible(panel,
                line(look->label, std::move(q), std::move(t), look->colour, 3.5, look->style));
  }
  out.figure.panels = {std::move(panel)};
  const wording::AxisScale size = wording::prefixed("N·m", span_of(a.torque_Nm));
  out.caption = tr(
      "Steady loops of the first oscillation in each: {first_height} high on {first_calibration}, "
      "{second_height} high on {second_calibration}; {first_width} and {second_width} wide.",
      {{"first_height", wording::with_unit(span_of(a.torque_Nm), size, 3)},
       {"first_calibration", looks[0].label},
       {"second_height", wording::with_unit(span_of(b.torque_Nm), size, 3)},
       {"second_calibration", looks[1].label},
       {"first_width", wording::with_unit(span_of(a.from_centre_rad), x, 3)},
       {"second_width", wording::with_unit(span_of(b.from_centre_rad), x, 3)}});
  out.how_to_read =
      tr("Loops of the same width can be compared: a higher one means more friction, one moved up "
         "or down a different gravity torque, steeper flanks a stiffer contact. Loops of different "
         "widths were driven differently.");
  out.alt = tr("Torque over angle of both calibrations.") + " " + out.caption;
  return out;
}

}  // namespace

std::vector<ReportFigure> comparison_figures(const history::Comparison& comparison,
                                             const calibration::RecordedCurves& first,
                                             const calibration::RecordedCurves& second) {
  std::vector<ReportFigure> all;
  if (auto made = friction_figure(comparison, first.friction, second.friction)) {
    all.push_back(std::move(*made));
  }
  if (auto made = loop_figure(comparison, first.loops, second.loops)) {
    all.push_back(std::move(*made));
  }
  return all;
}

}  // namespace tribolog::figures::timeline
