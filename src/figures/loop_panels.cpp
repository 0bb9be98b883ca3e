#include "figures/loop_panels.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "figures/estimator_style.h"
#include "figures/report_figure.h"
#include "wording/tr.h"

namespace tribolog::figures {

namespace {

constexpr double first_strokes = 1.25;  // periods: up, down, and up to where E has been passed
constexpr double most_cycles = 1e6;
constexpr double cycles_over_time = 2.25;
constexpr double near_share = 0.25;  // of the loop's width, beyond its ends

}  // namespace

double reading(const method::hysteresis::LoopPoint& point, LoopSignal signal) {
  switch (signal) {
    case LoopSignal::torque:
      return point.torque_Nm;
    case LoopSignal::deflection:
      return point.z_rad;
    case LoopSignal::deflection_rate:
      return point.dz_rad_s;
  }
  return std::nan("");
}

std::vector<double> LoopView::until(double end_s, const std::vector<double>& signal) const {
  const auto& t = trace->t_s;
  const auto end = std::upper_bound(t.begin(), t.end(), end_s) - t.begin();
  const auto length = std::min<std::ptrdiff_t>(end, static_cast<std::ptrdiff_t>(signal.size()));
  return {signal.begin(), signal.begin() + length};
}

wording::AxisScale LoopView::time() const { return {1.0, "s", trace->t_s.front()}; }

std::optional<LoopView> loop_view(const calibration::Calibration& calibration) {
  const method::hysteresis::HysteresisResult& loop = calibration.hysteresis;
  if (!loop.found || calibration.curves.loops.empty()) return std::nullopt;
  const method::hysteresis::LoopTrace& trace = calibration.curves.loops.front();
  if (trace.t_s.empty() || trace.q_rad.empty() || trace.torque_Nm.empty()) return std::nullopt;

  LoopView view;
  view.trace = &trace;
  view.modelled = !trace.z_rad.empty() && !loop.bristle_source.is("loop.bristle_recorded");
  if (!trace.t_s.empty() && trace.model_torque_Nm.size() == trace.t_s.size()) {
    view.model_torque_Nm = &trace.model_torque_Nm;
  }
  view.centre_rad = loop.midline_q_rad;
  const double start = trace.t_s.front();
  view.first_strokes_end_s = view.shown_end_s = trace.t_s.back();
  if (!loop.oscillations.empty()) {
    const method::hysteresis::Oscillation& oscillation = loop.oscillations.front();
    // Beyond belief counts as not known.
    view.cycles = std::abs(oscillation.cycles) < most_cycles ? oscillation.cycles : 0.0;
    view.centre_rad = oscillation.centre_rad;
    if (oscillation.frequency_Hz > 0.0) {
      const double period = 1.0 / oscillation.frequency_Hz;
      view.first_strokes_end_s = start + first_strokes * period;
      view.shown_end_s = start + cycles_over_time * period;
    }
  }
  // The readings belong to the first strokes by definition.
  for (const method::hysteresis::LoopPoint& point : loop.points) {
    if (std::isfinite(point.t_s)) {
      view.first_strokes_end_s = std::max(view.first_strokes_end_s, point.t_s);
      view.shown_end_s = std::max(view.shown_end_s, point.t_s);
    }
  }
  if (!std::isfinite(view.centre_rad)) view.centre_rad = 0.0;
  wording::Extent angles;
  for (const double q : trace.q_rad) angles.add(q - view.centre_rad);
  if (angles.empty) return std::nullopt;
  view.angle = wording::prefixed("rad", angles.largest());
  view.angle.offset = view.centre_rad;
  return view;
}

void add_loop_points(render::figure::Panel& panel,
                     const std::vector<method::hysteresis::LoopPoint>& points, LoopSignal signal,
                     bool over_time, const LoopView& view, const wording::AxisScale& y) {
  for (const method::hysteresis::LoopPoint& point : points) {
    const SeriesStyle style = estimator_style(point.name);
    add_visible(panel, render::figure::PointLabel{
                           over_time ? view.time()(point.t_s) : view.angle(point.q_rad),
                           y(reading(point, signal)), to_string(point.name),
                           render::figure::palette::black, style.marker});
  }
}

bool add_gravity_peak(render::figure::Panel& panel, const calibration::Calibration& calibration,
                      const LoopView& view) {
  if (!calibration.q_peak_rad || !std::isfinite(calibration.q_peak_rad->value)) return false;
  const double peak = calibration.q_peak_rad->value;
  const wording::Extent angles = wording::extent_of(view.trace->q_rad);
  const double margin = near_share * angles.span();
  if (peak < angles.low - margin || peak > angles.high + margin) return false;
  panel.reference_lines.push_back({render::figure::ReferenceLine::Direction::vertical,
                                   view.angle(peak), "q_{peak}", peak_colour,
                                   render::figure::LineStyle::dash_dot});
  return true;
}

namespace {

constexpr int two_panels_px = 1500;

render::figure::Panel over_angle(const calibration::Calibration& calibration, const LoopView& view,
                                 const LoopCurves& curves) {
  render::figure::Panel panel;
  panel.x.title = wording::axis_title(wording::tr("joint angle from the loop's centre q − q_{{0}}"),
                                      wording::AxisScale{view.angle.factor, view.angle.unit});
  panel.y.title = wording::axis_title(curves.title, curves.scale);
  if (curves.all != nullptr) {
    add_visible(panel, line(curves.all_label, shown(view.trace->q_rad, view.angle),
                            shown(*curves.all, curves.scale), cloud, cloud_px));
  }
  render::figure::Series strokes =
      line(curves.strokes_label,
           shown(view.until(view.first_strokes_end_s, view.trace->q_rad), view.angle),
           shown(view.until(view.first_strokes_end_s, *curves.strokes), curves.scale),
           render::figure::palette::blue, strokes_px);
  strokes.direction_arrows_at = {0.1, 0.3, 0.5, 0.7, 0.95};
  add_visible(panel, std::move(strokes));
  add_gravity_peak(panel, calibration, view);
  add_loop_points(panel, calibration.hysteresis.points, curves.signal, false, view, curves.scale);
  return panel;
}

render::figure::Panel over_time(const calibration::Calibration& calibration, const LoopView& view,
                                const LoopCurves& curves) {
  render::figure::Panel panel;
  panel.x.title = wording::tr("time t [s]");
  panel.y.title = wording::axis_title(curves.title, curves.scale);
  panel.show_legend = false;
  const wording::AxisScale time = view.time();
  const auto add = [&](const std::vector<double>& signal, render::figure::Colour colour,
                       double width) {
    add_visible(panel,
                line("", shown(view.until(view.shown_end_s, view.trace->t_s), time),
                     shown(view.until(view.shown_end_s, signal), curves.scale), colour, width));
  };
  // Over time the strokes hide what they were taken from.
  if (curves.all != nullptr && curves.all != curves.strokes) add(*curves.all, cloud, cloud_px);
  add(*curves.strokes, render::figure::palette::blue, strokes_px);
  add_loop_points(panel, calibration.hysteresis.points, curves.signal, true, view, curves.scale);
  return panel;
}

}  // namespace

ReportFigure two_panels(const calibration::Calibration& calibration, const LoopView& view,
                        const LoopCurves& curves) {
  ReportFigure out;
  out.stage = "hysteresis";
  out.figure.panels = {over_angle(calibration, view, curves), over_time(calibration, view, curves)};
  out.figure.height_px = two_panels_px;
  return out;
}

}  // namespace tribolog::figures
