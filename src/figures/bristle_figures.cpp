#include "figures/bristle_figures.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "figures/estimator_style.h"
#include "figures/loop_panels.h"
#include "figures/report_figure.h"
#include "wording/axis_scale.h"
#include "wording/labels.h"
#include "wording/number_text.h"
#include "wording/rounding.h"
#include "wording/tr.h"

namespace tribolog::figures {

namespace {

using method::hysteresis::LuGreParameterName;
using wording::tr;
using wording::tr_count;

constexpr double model_px = 3.0;
constexpr double zero_px = 1.5;

render::figure::Panel loop_panel(const LoopView& view, const wording::AxisScale& torque) {
  render::figure::Panel panel;
  panel.x.title = wording::axis_title(tr("joint angle from the loop's centre q − q_{{0}}"),
                                      wording::AxisScale{view.angle.factor, view.angle.unit});
  panel.y.title = wording::axis_title(tr("driving torque T"), torque);
  const method::hysteresis::LoopTrace& trace = *view.trace;
  add_visible(panel, line(tr("measured"), shown(trace.q_rad, view.angle),
                          shown(trace.torque_Nm, torque), cloud, cloud_px));
  add_visible(panel,
              line(tr("LuGre fit"), shown(trace.q_rad, view.angle),
                   shown(*view.model_torque_Nm, torque), render::figure::palette::blue, model_px));
  return panel;
}

render::figure::Panel misfit_panel(const LoopView& view,
                                   const method::hysteresis::LoopMisfit& misfit, double residual_Nm,
                                   const wording::AxisScale& torque) {
  render::figure::Panel panel;
  panel.x.title = wording::axis_title(tr("joint angle from the loop's centre q − q_{{0}}"),
                                      wording::AxisScale{view.angle.factor, view.angle.unit});
  panel.y.title = wording::axis_title(tr("mean of T − fit"), torque);
  const std::vector<double> q = shown(misfit.q_rad, view.angle);
  if (!q.empty()) {
    const std::vector<double> high(q.size(), torque(residual_Nm));
    const std::vector<double> low(q.size(), -torque(residual_Nm));
    panel.bands.push_back({tr("scatter of single samples"), q, low, high, faded(cloud, 120)});
    add_visible(panel, line("", {q.front(), q.back()}, {0.0, 0.0}, render::figure::palette::black,
                            zero_px));
  }
  add_visible(panel,
              line(tr("while the angle grows"), q, shown(misfit.rising_Nm, torque), rising_colour));
  add_visible(panel, line(tr("while it falls"), q, shown(misfit.falling_Nm, torque), falling_colour,
                          2.5, render::figure::LineStyle::dash));
  return panel;
}

/// "From the loop alone: σ₀ 465.4 ± 1.2 N·m/rad and T_s 0.884 ± 0.002 N·m."
std::string found_sentence(const method::hysteresis::LuGreFit& fit) {
  std::vector<std::string> found;
  const auto add = [&](LuGreParameterName name, const char* symbol, const char* unit) {
    if (const auto e = fit.shown(name)) {
      found.push_back(std::string(symbol) + " " +
                      wording::in_words(*e, wording::quantity_scale(unit, e->value)));
    }
  };
  add(LuGreParameterName::bristle_stiffness, "σ₀", "N·m/rad");
  add(LuGreParameterName::bristle_damping, "σ₁", "N·m·s/rad");
  add(LuGreParameterName::static_torque, "Ts", "N·m");
  add(LuGreParameterName::coulomb_torque, "Tc", "N·m");
  add(LuGreParameterName::stribeck_speed, "ωs", "rad/s");
  if (found.empty()) return tr("From the loop alone: no parameter is identified.");
  return tr("From the loop alone: {parameters}.", {{"parameters", wording::listed(found)}});
}

}  // namespace

std::optional<ReportFigure> lugre_loop_figure(const calibration::Calibration& calibration) {
  const auto& fit = calibration.lugre;
  const auto view = loop_view(calibration);
  if (!view || !fit || !fit->converged || view->model_torque_Nm == nullptr) return std::nullopt;
  const auto of_view = std::find_if(fit->loops.begin(), fit->loops.end(),
                                    [&](const method::hysteresis::LuGreLoop& one) {
                                      return one.recording == view->trace->recording;
                                    });
  if (of_view == fit->loops.end()) return std::nullopt;
  const method::hysteresis::LuGreLoop& loop = *of_view;
  wording::Extent misfit;
  misfit.add(loop.misfit.rising_Nm);
  misfit.add(loop.misfit.falling_Nm);
  ReportFigure out;
  out.id = "fig-lugre-loop";
  out.is_primary = true;
  out.title = tr("LuGre fitted to the hysteresis loop");
  out.stage = "friction_parameters";
  const wording::AxisScale torque =
      wording::prefixed("N·m", wording::extent_of(view->trace->torque_Nm).largest());
  const wording::AxisScale small =
      wording::prefixed("N·m", std::max(misfit.largest(), loop.residual_Nm));
  out.figure.panels.push_back(loop_panel(*view, torque));
  if (!misfit.empty) {
    out.figure.panels.push_back(misfit_panel(*view, loop.misfit, loop.residual_Nm, small));
    out.figure.panels_share_x = true;
    out.figure.height_px = 1500;
  }
  const std::string scatter =
      wording::size_words(loop.residual_Nm, wording::torque_floor_Nm, "N·m");
  const std::string left = wording::size_words(misfit.largest(), wording::torque_floor_Nm, "N·m");
  out.caption = found_sentence(*fit) + " " +
                tr("Single samples scatter about the fit by {scatter}; averaged over the angle, "
                   "the residual is at most {misfit}.",
                   {{"scatter", scatter}, {"misfit", left}});
  if (fit->loops.size() > 1) {
    out.caption += " " + tr("The first of {loops} loops that were fitted together.",
                            {{"loops", fit->loops.size()}});
  }
  out.how_to_read =
      tr("Below, the mean should lie far inside the band and cross zero often. A bow or a step "
         "seen in both directions is friction that this model does not have; opposite signs in the "
         "two directions mean a loop that is too wide or too narrow.");
  out.alt =
      tr("Measured torque against joint angle with the fitted LuGre loop, and the mean residual of "
         "the fit, at most {misfit} against a scatter of {scatter}.",
         {{"misfit", left}, {"scatter", scatter}});
  return out;
}

namespace {

constexpr double smallest_share = 1e-5;  // of the furthest travel, on the logarithmic axis

struct Direction {
  bool is_rising;
  const char* words;
  const char* break_away_words;
  const char* censored_words;
  render::figure::Colour colour;
  render::figure::LineStyle style;
  render::figure::Marker marker;
};

const Direction directions[] = {
    {true, wording::to_translate("towards positive torque"),
     wording::to_translate("break-away, towards positive torque"),
     wording::to_translate("censored, towards positive torque"), render::figure::palette::blue,
     render::figure::LineStyle::solid, render::figure::Marker::circle},
    {false, wording::to_translate("towards negative torque"),
     wording::to_translate("break-away, towards negative torque"),
     wording::to_translate("censored, towards negative torque"), render::figure::palette::vermilion,
     render::figure::LineStyle::dash, render::figure::Marker::square}};

const joint::Recording* find_recording(const joint::Dataset& dataset, const std::string& name) {
  for (const joint::Recording* r : dataset.with_role(joint::Role::break_away)) {
    if (r->name == name) return r;
  }
  return nullptr;
}

/// Up to where the torque is largest in the ramp's direction: what follows is no ramp any more.
std::size_t ramp_end(const joint::Recording& r, double sign) {
  std::size_t end = 0;
  for (std::size_t i = 0; i < r.size(); ++i) {
    if (sign * (r.torque_Nm[i] - r.torque_Nm[end]) > 0) end = i;
  }
  return end + 1;
}

double furthest_travel(const joint::Dataset& dataset,
                       const method::hysteresis::BreakAwayResult& result) {
  double furthest = 0;
  for (const method::hysteresis::BreakAwayRamp& ramp : result.ramps) {
    const joint::Recording* r = find_recording(dataset, ramp.recording);
    if (r == nullptr) continue;
    const double sign = ramp.is_rising ? 1 : -1;
    for (std::size_t i = 0; i < ramp_end(*r, sign); ++i) {
      const double travel = sign * (r->q_rad[i] - r->q_rad.front());
      if (std::isfinite(travel)) furthest = std::max(furthest, travel);
    }
  }
  return furthest;
}

/// Travel against the torque's magnitude.
struct TravelCurve {
  std::vector<double> torque_Nm;
  std::vector<double> travel_rad;
};

TravelCurve curve_of(const joint::Recording& r, bool is_rising,
                     const method::hysteresis::BreakAwayResult& result, double floor_rad) {
  const double sign = is_rising ? 1 : -1;
  TravelCurve curve;
  for (std::size_t i = 0; i < ramp_end(r, sign); ++i) {
    const double travel = sign * (r.q_rad[i] - r.q_rad.front());
    if (!(travel > floor_rad)) continue;  // standing still has no place on a logarithmic axis
    curve.torque_Nm.push_back(result.torque_along(is_rising, r.torque_Nm[i], r.q_rad[i]));
    curve.travel_rad.push_back(travel);
  }
  return curve;
}

void add_curves(const joint::Dataset& dataset, const method::hysteresis::BreakAwayResult& result,
                const Direction& direction, double floor_rad, render::figure::Panel& panel) {
  std::string label = tr(direction.words);
  for (const method::hysteresis::BreakAwayRamp& ramp : result.ramps) {
    const joint::Recording* r = find_recording(dataset, ramp.recording);
    if (r == nullptr || ramp.is_rising != direction.is_rising) continue;
    TravelCurve curve = curve_of(*r, ramp.is_rising, result, floor_rad);
    if (add_visible(panel, line(label, std::move(curve.torque_Nm), std::move(curve.travel_rad),
                                lightened(direction.colour, 0.35), 2.0, direction.style))) {
      label.clear();
    }
  }
}

void add_marks(const method::hysteresis::BreakAwayResult& result, const Direction& direction,
               bool broke_away, double floor_rad, render::figure::Panel& panel) {
  render::figure::Series marks =
      line(tr(broke_away ? direction.break_away_words : direction.censored_words), {}, {},
           direction.colour, 1.0, render::figure::LineStyle::none);
  marks.marker = broke_away ? direction.marker : render::figure::Marker::cross;
  marks.marker_size_px = 14.0;
  for (const method::hysteresis::BreakAwayRamp& ramp : result.ramps) {
    if (ramp.is_rising != direction.is_rising || ramp.broke_away != broke_away) continue;
    const double sign = ramp.is_rising ? 1 : -1;
    const double q_rad = ramp.q_start_rad + sign * ramp.travel_rad;
    marks.x.push_back(result.torque_along(ramp.is_rising, ramp.torque_Nm, q_rad));
    marks.y.push_back(std::max(ramp.travel_rad, floor_rad));
  }
  add_visible(panel, std::move(marks));
}

std::string found_words(const method::hysteresis::BreakAwayResult& result) {
  const wording::AxisScale torque{1.0, "N·m"};
  const auto words = [&](const std::optional<statistics::Estimate>& break_away) {
    return break_away ? wording::with_interval(*break_away, torque) : std::string();
  };
  const std::string rising = words(result.rising_Nm);
  const std::string falling = words(result.falling_Nm);
  if (rising.empty() && falling.empty()) return tr("no break-away torque");
  if (falling.empty()) {
    return tr("break-away at {rising} towards positive torque", {{"rising", rising}});
  }
  if (rising.empty()) {
    return tr("break-away at {falling} towards negative torque", {{"falling", falling}});
  }
  return tr("break-away at {rising} towards positive torque and {falling} towards negative torque",
            {{"rising", rising}, {"falling", falling}});
}

/// What was found, and how many ramps ended before that.
std::string found_and_censored(const method::hysteresis::BreakAwayResult& result) {
  const std::string found = found_words(result);
  if (result.censored == 0) return found;
  return tr_count(static_cast<std::int64_t>(result.censored),
                  "{break_away}; {censored} ramp ended before the joint broke away (censored)",
                  "{break_away}; {censored} ramps ended before the joint broke away (censored)",
                  {{"break_away", found}, {"censored", result.censored}});
}

}  // namespace

std::optional<ReportFigure> break_away_figure(const joint::Dataset& dataset,
                                              const calibration::Calibration& calibration) {
  const method::hysteresis::BreakAwayResult& result = calibration.break_away;
  const double furthest = furthest_travel(dataset, result);
  if (result.ramps.empty() || !(furthest > 0)) return std::nullopt;
  ReportFigure out;
  out.id = "fig-break-away-ramps";
  out.title = tr("Break-away ramps");
  out.stage = "break_away";
  render::figure::Panel panel;
  panel.x.title = result.gravity ? tr("torque less gravity, in the ramp's direction [N·m]")
                                 : tr("torque in the ramp's direction [N·m]");
  panel.y.title = tr("travel of the joint from rest [rad]");
  panel.y.logarithmic = true;
  const double floor = smallest_share * furthest;
  for (const Direction& d : directions) add_curves(dataset, result, d, floor, panel);
  for (const Direction& d : directions) {
    add_marks(result, d, true, floor, panel);
    add_marks(result, d, false, floor, panel);
  }
  if (panel.series.empty()) return std::nullopt;
  out.figure.panels.push_back(std::move(panel));
  out.caption =
      tr_count(static_cast<std::int64_t>(result.ramps.size()),
               "Travel against torque in {ramps} ramp: {break_away}.",
               "Travel against torque in {ramps} ramps: {break_away}.",
               {{"ramps", result.ramps.size()}, {"break_away", found_and_censored(result)}});
  out.how_to_read =
      tr("From left to right the torque rises; samples at which the joint has not moved are not "
         "drawn. In pre-sliding the travel grows smoothly; at break-away it leaps by decades. "
         "Steps after the first leap are slips that were caught again, by gravity or by friction "
         "that varies with the angle. Ramps in one direction that leap at different torques show "
         "how much the break-away torque itself scatters.");
  out.alt = out.caption;
  return out;
}

}  // namespace tribolog::figures
