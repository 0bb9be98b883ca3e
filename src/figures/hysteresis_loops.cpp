#include "figures/hysteresis_loops.h"

#include <cstdint>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "figures/loop_panels.h"
#include "figures/report_figure.h"
#include "wording/number_text.h"
#include "wording/tr.h"

namespace tribolog::figures {
namespace {

using wording::tr;
using wording::tr_count;

std::string cycles_words(const LoopView& view) {
  if (view.cycles < 1.0) return tr("measured");
  const auto cycles = static_cast<std::int64_t>(view.cycles);
  return tr_count(cycles, "measured, {cycles} cycle", "measured, {cycles} cycles",
                  {{"cycles", cycles}});
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
    words.push_back(
        fmt::format("{} {}", to_string(point.name), wording::to_place(scale(value), largest, 4)));
  }
  return words.empty() ? std::string() : wording::listed(words) + " " + scale.unit;
}

/// What the reader must know of where the curves come from; begins with a space.
std::string origin_words(const calibration::Calibration& calibration, const LoopView& view) {
  const std::size_t loops = calibration.curves.loops.size();
  std::string text;
  if (loops > 1) {
    text +=
        " " + tr("The first of {oscillations} oscillations is shown.", {{"oscillations", loops}});
  }
  if (view.modelled) {
    text += " " + tr("The bristle deflection is not measured: it is that of the LuGre model fitted "
                     "to the torque.");
  }
  return text;
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
                          tr("driving torque T"),
                          &trace.torque_Nm,
                          model ? view->model_torque_Nm : &trace.torque_Nm,
                          cycles_words(*view),
                          model ? tr("first strokes, LuGre fit") : tr("first strokes"),
                          wording::prefixed("N·m", wording::extent_of(trace.torque_Nm).largest())};
  ReportFigure out = two_panels(calibration, *view, torque);
  out.paper_number = 15;
  out.is_primary = true;
  out.id = "fig-15-hysteresis";
  out.title = tr("Friction hysteresis: driving torque");
  if (!out.figure.panels.empty()) {
    add_visible(out.figure.panels.front(),
                line(tr("mid-line of the steady loop"), shown(trace.midline_q_rad, view->angle),
                     shown(trace.midline_Nm, torque.scale), render::figure::palette::black, 3.0,
                     render::figure::LineStyle::dash));
  }
  const wording::AxisScale newton_metre = wording::prefixed("N·m", loop.loop_height_Nm);
  const std::string height = wording::with_unit(loop.loop_height_Nm, newton_metre, 4);
  const std::string midline =
      loop.midline_Nm ? wording::with_interval(*loop.midline_Nm, torque.scale) : tr("unknown");
  const std::string points = points_words(calibration, LoopSignal::torque, torque.scale);
  out.caption =
      tr("Loop of {height} height; the mean of the mid-line of the steady loop is {midline}.",
         {{"height", height}, {"midline", midline}});
  if (!points.empty()) out.caption += " " + tr("Readings: {readings}.", {{"readings", points}});
  out.caption += origin_words(calibration, *view);
  out.how_to_read =
      tr("From rest at A the torque climbs into the loop; every later cycle should lie on the one "
         "before. Gravity is the mean of the mid-line: a loop that drifts, or that is a plain "
         "ellipse without "
         "flat ends, has not left pre-sliding or was not yet steady, and its points then read low "
         "or high.");
  out.alt =
      points.empty()
          ? tr("Hysteresis loop of driving torque over joint angle, {height} high, mean of the "
               "mid-line {midline}.",
               {{"height", height}, {"midline", midline}})
          : tr("Hysteresis loop of driving torque over joint angle, {height} high, mean of the "
               "mid-line {midline}; points {readings}.",
               {{"height", height}, {"midline", midline}, {"readings", points}});
  return out;
}

namespace {

std::string alt_of_bristle(bool rate, const std::string& largest, const std::string& readings) {
  if (readings.empty()) {
    return rate ? tr("Bristle rate over joint angle and over time, up to {largest}.",
                     {{"largest", largest}})
                : tr("Bristle deflection over joint angle and over time, up to {largest}.",
                     {{"largest", largest}});
  }
  return rate ? tr("Bristle rate over joint angle and over time, up to {largest}; points "
                   "{readings}.",
                   {{"largest", largest}, {"readings", readings}})
              : tr("Bristle deflection over joint angle and over time, up to {largest}; points "
                   "{readings}.",
                   {{"largest", largest}, {"readings", readings}});
}

std::optional<ReportFigure> bristle_figure(const calibration::Calibration& calibration,
                                           LoopSignal signal) {
  const auto view = loop_view(calibration);
  if (!view) return std::nullopt;
  const bool rate = signal == LoopSignal::deflection_rate;
  const std::vector<double>& values = rate ? view->trace->dz_rad_s : view->trace->z_rad;
  const double largest = wording::extent_of(values).largest();
  if (wording::extent_of(values).empty) return std::nullopt;
  const LoopCurves bristle{
      signal,
      rate ? tr("bristle rate ż") : tr("bristle deflection z"),
      &values,
      &values,
      view->modelled ? tr("LuGre model, all cycles") : tr("recorded, all cycles"),
      tr("first strokes"),
      wording::prefixed(rate ? "rad/s" : "rad", largest)};
  ReportFigure out = two_panels(calibration, *view, bristle);
  const std::string points = points_words(calibration, signal, bristle.scale);
  const std::string most = wording::with_unit(largest, bristle.scale, 4);
  out.caption = rate ? tr("Rate of deflection of the bristles, up to {largest} at the motor.",
                          {{"largest", most}})
                     : tr("Mean deflection of the bristles, up to {largest} at the motor.",
                          {{"largest", most}});
  if (!points.empty()) {
    out.caption += " " + tr("At the points: {readings}.", {{"readings", points}});
  }
  out.caption += origin_words(calibration, *view);
  out.alt = alt_of_bristle(rate, most, points);
  return out;
}

}  // namespace

std::optional<ReportFigure> bristle_loop_figure(const calibration::Calibration& calibration) {
  auto out = bristle_figure(calibration, LoopSignal::deflection);
  if (!out) return out;
  out->paper_number = 16;
  out->id = "fig-16-bristle-deflection";
  out->title = tr("Friction hysteresis: bristle deflection");
  out->how_to_read =
      tr("A and B are the crossings of zero, where friction carries no elastic torque; C and D the "
         "extremes. The loop should flatten towards C and D: if it is still steep there, the "
         "oscillation is too small to reach break-away and its points say little about friction.");
  return out;
}

std::optional<ReportFigure> bristle_rate_loop_figure(const calibration::Calibration& calibration) {
  auto out = bristle_figure(calibration, LoopSignal::deflection_rate);
  if (!out) return out;
  out->paper_number = 17;
  out->id = "fig-17-bristle-rate";
  out->title = tr("Friction hysteresis: bristle rate");
  out->how_to_read = tr(
      "E and F are the extremes of the rate, shortly after each reversal while the bristles swing "
      "back; towards the ends of a stroke the rate returns to zero as they slide. A rate that "
      "follows the speed of the arm throughout is a bristle that never slides.");
  return out;
}

}  // namespace tribolog::figures
