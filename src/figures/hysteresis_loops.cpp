#include "figures/hysteresis_loops.h"

#include <string>
#include <vector>

#include <fmt/format.h>

#include "figures/loop_panels.h"
#include "figures/report_figure.h"
#include "wording/number_text.h"

namespace tribolog::figures {
namespace {

std::string cycles_words(const LoopView& view) {
  if (view.cycles < 1.0) return "measured";
  return "measured, " + wording::counted(static_cast<std::size_t>(view.cycles), "cycle");
}

/// "A 3.924, C 4.759, ... N·m", in the order of the calibration.
std::string points_words(const calibration::Calibration& calibration, LoopSignal signal,
                         const wording::AxisScale& scale) {
  wording::Extent values;
  for (const method::hysteresis::LoopPoint& point : calibration.hysteresis.points) {
    values.add(scale(reading(point, signal)));
  }
  const double largest = values.largest();
  std::vector<std::string> words;
  for (const method::hysteresis::LoopPoint& point : calibration.hysteresis.points) {
    const double value = reading(point, signal);
    words.push_back(fmt::format("{} {}", point.name, wording::to_place(scale(value), largest, 4)));
  }
  return words.empty() ? std::string() : wording::listed(words) + " " + scale.unit;
}

std::string bristle_words(const LoopView& view) {
  return view.modelled ? " The bristle is not measured: it is that of the LuGre model fitted to "
                         "the torque."
                       : "";
}

/// What the reader must know of where the curves come from.
std::string origin_words(const calibration::Calibration& calibration, const LoopView& view) {
  const std::size_t loops = calibration.hysteresis.traces.size();
  const std::string which =
      loops > 1 ? fmt::format(" The first of {} oscillations is shown.", loops) : std::string();
  return which + bristle_words(view);
}

}  // namespace

std::optional<ReportFigure> torque_loop_figure(const calibration::Calibration& calibration) {
  const auto view = loop_view(calibration);
  if (!view) return std::nullopt;
  const method::hysteresis::HysteresisResult& loop = calibration.hysteresis;
  const method::hysteresis::LoopTrace& trace = *view->trace;
  const bool model =
      view->model_torque_Nm != nullptr && !loop.bristle_source.is("loop.bristle_recorded");
  const LoopCurves torque{LoopSignal::torque,
                          "driving torque T",
                          &trace.torque_Nm,
                          model ? view->model_torque_Nm : &trace.torque_Nm,
                          cycles_words(*view),
                          model ? "first strokes, LuGre fit" : "first strokes",
                          wording::prefixed("N·m", wording::extent_of(trace.torque_Nm).largest())};
  ReportFigure out = two_panels(calibration, *view, torque);
  out.number = 15;
  out.id = "fig-15-hysteresis";
  out.title = "Friction hysteresis: driving torque";
  if (!out.figure.panels.empty()) {
    add_visible(out.figure.panels.front(),
                line("mid-line of the steady loop", shown(trace.midline_q_rad, view->angle),
                     shown(trace.midline_Nm, torque.scale), render::figure::palette::black, 3.0,
                     render::figure::LineStyle::dash));
  }
  const wording::AxisScale newton_metre = wording::prefixed("N·m", loop.loop_height_Nm);
  const std::string height = wording::with_unit(loop.loop_height_Nm, newton_metre, 4);
  const std::string midline = loop.midline_Nm
                                  ? wording::with_interval(*loop.midline_Nm, torque.scale)
                                  : std::string("unknown");
  const std::string points = points_words(calibration, LoopSignal::torque, torque.scale);
  out.caption = fmt::format("Loop of {} height; the mid-line of the steady loop averages {}.{}{}",
                            height, midline, points.empty() ? "" : " Readings: " + points + ".",
                            origin_words(calibration, *view));
  out.how_to_read =
      "From rest at A the torque climbs into the loop; every later cycle should lie on the one "
      "before. Gravity is the mid-line: a loop that drifts, or that is a bare ellipse without flat "
      "ends, has not left pre-sliding or was not yet steady, and its points then read low or high.";
  out.alt =
      fmt::format("Hysteresis loop of driving torque over joint angle, {} high, mid-line at {}{}.",
                  height, midline, points.empty() ? "" : "; points " + points);
  return out;
}

namespace {

std::optional<ReportFigure> bristle_figure(const calibration::Calibration& calibration,
                                           LoopSignal signal) {
  const auto view = loop_view(calibration);
  if (!view) return std::nullopt;
  const bool rate = signal == LoopSignal::deflection_rate;
  const std::vector<double>& values = rate ? view->trace->dz_rad_s : view->trace->z_rad;
  const double largest = wording::extent_of(values).largest();
  if (wording::extent_of(values).empty) return std::nullopt;
  const LoopCurves bristle{signal,
                           rate ? "bristle rate ż" : "bristle deflection z",
                           &values,
                           &values,
                           view->modelled ? "LuGre model, all cycles" : "recorded, all cycles",
                           "first strokes",
                           wording::prefixed(rate ? "rad/s" : "rad", largest)};
  ReportFigure out = two_panels(calibration, *view, bristle);
  const std::string points = points_words(calibration, signal, bristle.scale);
  const std::string most = wording::with_unit(largest, bristle.scale, 4);
  out.caption = fmt::format("{} of the bristles, up to {} at the motor.{}{}",
                            rate ? "Rate of deflection" : "Mean deflection", most,
                            points.empty() ? "" : " At the points: " + points + ".",
                            origin_words(calibration, *view));
  out.alt = fmt::format("{} over joint angle and over time, up to {}{}.",
                        rate ? "Bristle rate" : "Bristle deflection", most,
                        points.empty() ? "" : "; points " + points);
  return out;
}

}  // namespace

std::optional<ReportFigure> bristle_loop_figure(const calibration::Calibration& calibration) {
  auto out = bristle_figure(calibration, LoopSignal::deflection);
  if (!out) return out;
  out->number = 16;
  out->id = "fig-16-bristle-deflection";
  out->title = "Friction hysteresis: bristle deflection";
  out->how_to_read =
      "A and B are the crossings of zero, where friction carries no elastic torque; C and D the "
      "extremes. The loop should flatten towards C and D: if it is still steep there, the "
      "oscillation is too small to break away and its points say little about friction.";
  return out;
}

std::optional<ReportFigure> bristle_rate_loop_figure(const calibration::Calibration& calibration) {
  auto out = bristle_figure(calibration, LoopSignal::deflection_rate);
  if (!out) return out;
  out->number = 17;
  out->id = "fig-17-bristle-rate";
  out->title = "Friction hysteresis: bristle rate";
  out->how_to_read =
      "E and F are the extremes of the rate, shortly after each reversal while the bristles swing "
      "back; towards the ends of a stroke the rate returns to zero as they slide. A rate that "
      "follows the speed of the arm throughout is a bristle that never slides.";
  return out;
}

}  // namespace tribolog::figures
