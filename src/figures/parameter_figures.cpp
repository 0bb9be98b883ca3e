#include "figures/parameter_figures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "figures/estimator_style.h"
#include "figures/report_figure.h"
#include "figures/run_curves.h"
#include "wording/axis_scale.h"
#include "wording/labels.h"
#include "wording/number_text.h"
#include "wording/tr.h"
#include "wording/words.h"

namespace tribolog::figures {

namespace {

using wording::tr;
using wording::tr_count;

namespace colour = render::figure::palette;
using render::figure::LineStyle;

constexpr double wide_range = 30.0;  // fastest over slowest: a logarithmic axis shows the dip
constexpr double chosen_px = 5.0;
constexpr double other_px = 2.5;
constexpr double circle_px = 31.0;
constexpr double diamond_px = 14.0;

struct LawStyle {
  render::figure::Colour colour;
  render::figure::LineStyle style;
};

LawStyle style_of(method::viscous::CurveLaw law) {
  constexpr std::array<LawStyle, 5> styles{
      {{colour::grey, render::figure::LineStyle::dot},
       {colour::green, render::figure::LineStyle::dash},
       {colour::orange, render::figure::LineStyle::dash_dot},
       {colour::purple, render::figure::LineStyle::dash_dot_dot},
       {colour::black, render::figure::LineStyle::solid}}};
  return styles[static_cast<std::size_t>(law)];
}

render::figure::Panel curves_panel(const calibration::Calibration& c,
                                   const wording::AxisScale& scale) {
  const method::viscous::CurveModelChoice& choice = c.curve_model;
  render::figure::Panel panel;
  panel.x.title = wording::speed_size(c.manifest) + " [rad/s]";
  panel.y.title = wording::axis_title(tr("friction along the motion T_{{f}}"), scale);
  const wording::Extent speeds = wording::extent_of(choice.curve_speed_rad_s);
  if (speeds.low > 0 && speeds.high > wide_range * speeds.low) {
    panel.x.logarithmic = true;
    panel.x.minimum = 0.8 * speeds.low;
    panel.x.maximum = 1.25 * speeds.high;
  }
  add_folded_curve(panel, c, choice.curve, scale, true);
  panel.error_bars.clear();  // those are figure 21's
  for (render::figure::Series& series : panel.series) {
    // To be seen beside the lines, and both where the directions agree.
    series.marker_size_px =
        series.marker == render::figure::Marker::diamond ? diamond_px : circle_px;
  }
  for (const method::viscous::CurveModelTrial& trial : choice.ladder) {
    if (!trial.excluded_because.empty()) continue;
    const bool is_chosen = trial.model.law == choice.chosen.law;
    const LawStyle style = style_of(trial.model.law);
    const std::string model = wording::words(method::viscous::described(trial.model.law));
    add_visible(panel, line(is_chosen ? tr("{model} (chosen)", {{"model", model}}) : model,
                            choice.curve_speed_rad_s, shown(trial.curve_Nm, scale), style.colour,
                            is_chosen ? chosen_px : other_px, style.style));
  }
  return panel;
}

render::figure::Panel errors_panel(const method::viscous::CurveModelChoice& choice) {
  wording::Extent errors;
  for (const method::viscous::CurveModelTrial& t : choice.ladder) {
    if (!t.excluded_because.empty()) continue;
    errors.add(t.held_out_rms_Nm);
    errors.add(t.training_rms_Nm);
  }
  const wording::AxisScale scale = wording::prefixed("N·m", errors.largest());
  render::figure::Panel panel;
  panel.x.title = tr("parameters of the model");
  panel.x.counts = true;
  panel.y.title = wording::axis_title(tr("rms error"), scale);
  panel.y.minimum = 0;
  render::figure::Series held = line(tr("at held-out speeds: decides"), {}, {}, colour::vermilion);
  render::figure::Series training =
      line(tr("on its own data"), {}, {}, colour::blue, 2.5, render::figure::LineStyle::dash);
  held.marker = render::figure::Marker::circle;
  training.marker = render::figure::Marker::square;
  held.marker_size_px = training.marker_size_px = 13.0;
  for (const method::viscous::CurveModelTrial& t : choice.ladder) {
    if (!t.excluded_because.empty()) continue;
    const double parameters = t.model.parameters();
    held.x.push_back(parameters);
    training.x.push_back(parameters);
    held.y.push_back(scale(t.held_out_rms_Nm));
    training.y.push_back(scale(t.training_rms_Nm));
    if (t.model.law == choice.chosen.law) {
      add_visible(panel,
                  render::figure::PointLabel{parameters, held.y.back(), tr("chosen"),
                                             colour::vermilion, render::figure::Marker::none});
    }
  }
  const wording::Extent counts = wording::extent_of(held.x);
  panel.x.minimum = counts.low - 0.5;
  panel.x.maximum = counts.high + 0.5;
  add_visible(panel, std::move(held));
  add_visible(panel, std::move(training));
  return panel;
}

}  // namespace

std::optional<ReportFigure> curve_model_figure(const calibration::Calibration& c) {
  const method::viscous::CurveModelChoice& choice = c.curve_model;
  const method::viscous::ViscousCurve* curve = c.viscous.find(choice.curve);
  if (!choice.chosen_any || curve == nullptr) return std::nullopt;
  const method::viscous::CurveModelTrial* chosen = choice.find(choice.chosen.law);
  if (chosen == nullptr) return std::nullopt;
  ReportFigure out;
  out.id = "fig-curve-models";
  out.is_primary = true;
  out.title = tr("Which friction model the curve supports");
  out.stage = "friction_parameters";
  out.figure.panels.push_back(
      curves_panel(c, wording::prefixed("N·m", wording::extent_of(curve->friction_Nm).largest())));
  if (out.figure.panels.front().series.empty()) return std::nullopt;
  out.figure.panels.push_back(errors_panel(choice));
  out.figure.height_px = 1400;
  const std::string error =
      wording::size_words(chosen->held_out_rms_Nm, wording::torque_floor_Nm, "N·m");
  const std::string model = wording::words(method::viscous::described(choice.chosen));
  const int parameters = choice.chosen.parameters();
  out.caption = tr_count(
      parameters,
      "Chosen: {model} ({parameters} parameter), with an error of {error} at held-out speeds.",
      "Chosen: {model} ({parameters} parameters), with an error of {error} at held-out speeds.",
      {{"model", model}, {"parameters", parameters}, {"error", error}});
  out.how_to_read = tr(
      "Above, the models and the curve; where a term for load or direction was included they are "
      "drawn at the mean load and the mean of the directions, and the points scatter about them. "
      "Below, at the same speeds: the error on a model's own data falls with every parameter and "
      "says nothing; the error at held-out speeds stops falling, or rises, where the parameters "
      "begin to follow noise. The simplest model within one standard error of the best is chosen.");
  const auto models = static_cast<std::int64_t>(choice.ladder.size());
  out.alt =
      tr_count(models,
               "Friction curves of {models} model over the measured curve, and their errors "
               "against the number of parameters.",
               "Friction curves of {models} models over the measured curve, and their errors "
               "against the number of parameters.",
               {{"models", models}}) +
      " " +
      tr("Chosen: {model}, {error} at held-out speeds.", {{"model", model}, {"error", error}});
  return out;
}

namespace {

bool breaks_any(const calibration::Calibration& c, const std::vector<std::string>& rules) {
  return std::any_of(c.judgement.rules.begin(), c.judgement.rules.end(),
                     [&](const calibration::RuleOutcome& outcome) {
                       return outcome.state == calibration::RuleState::broken &&
                              std::find(rules.begin(), rules.end(), outcome.rule) != rules.end();
                     });
}

void add_line(render::figure::Panel& panel, const std::optional<method::viscous::DirectionLine>& l,
              bool rising, const wording::AxisScale& scale) {
  if (!l) return;
  const auto at = [&](double w) {
    return scale(l->coulomb_Nm.value + l->viscous_Nms_rad.value * w);
  };
  add_visible(
      panel,
      line(rising ? tr("line, forward") : tr("line, backward"),
           {l->slowest_rad_s, l->fastest_rad_s}, {at(l->slowest_rad_s), at(l->fastest_rad_s)},
           rising ? rising_colour : falling_colour, 4.0,
           rising ? render::figure::LineStyle::solid : render::figure::LineStyle::dash));
}

std::string words(const std::optional<method::viscous::DirectionLine>& l, bool rising) {
  if (!l) return rising ? tr("Forward: too few speeds.") : tr("Backward: too few speeds.");
  const std::string coulomb =
      wording::with_interval(l->coulomb_Nm, wording::prefixed("N·m", l->coulomb_Nm.value));
  const std::string viscous = wording::with_interval(
      l->viscous_Nms_rad, wording::prefixed("N·m·s/rad", l->viscous_Nms_rad.value));
  const auto runs = static_cast<std::int64_t>(l->runs);
  if (rising) {
    return tr_count(runs, "Forward: Coulomb {coulomb}, viscous {viscous}, from {runs} run.",
                    "Forward: Coulomb {coulomb}, viscous {viscous}, from {runs} runs.",
                    {{"coulomb", coulomb}, {"viscous", viscous}, {"runs", runs}});
  }
  return tr_count(runs, "Backward: Coulomb {coulomb}, viscous {viscous}, from {runs} run.",
                  "Backward: Coulomb {coulomb}, viscous {viscous}, from {runs} runs.",
                  {{"coulomb", coulomb}, {"viscous", viscous}, {"runs", runs}});
}

}  // namespace

std::optional<ReportFigure> direction_lines_figure(const calibration::Calibration& c) {
  if (c.viscous.from_sweep) return std::nullopt;
  const method::viscous::CurveDirectionLines* lines =
      c.direction_lines.find(method::hysteresis::Estimator::stated);
  if (lines == nullptr) lines = c.direction_lines.find(c.selection.recommended);
  if (lines == nullptr || (!lines->rising && !lines->falling)) return std::nullopt;
  const method::viscous::ViscousCurve* curve = c.viscous.find(lines->estimator);
  if (curve == nullptr) return std::nullopt;
  const wording::AxisScale scale =
      wording::prefixed("N·m", wording::extent_of(curve->friction_Nm).largest());
  ReportFigure out;
  out.id = "fig-directions";
  out.is_primary = breaks_any(c, {"friction_by_direction", "friction_by_direction_large",
                                  "direction_asymmetry", "torque_offset"});
  out.title = tr("Friction in each direction");
  out.stage = "friction_parameters";
  render::figure::Panel panel;
  panel.x.title = wording::speed_size(c.manifest) + " [rad/s]";
  panel.y.title = wording::axis_title(tr("friction along the motion T_{{f}}"), scale);
  add_folded_curve(panel, c, lines->estimator, scale, true);
  add_line(panel, lines->rising, true, scale);
  add_line(panel, lines->falling, false, scale);
  if (panel.series.empty()) return std::nullopt;
  out.figure.panels.push_back(std::move(panel));
  const std::string both = words(lines->rising, true) + " " + words(lines->falling, false);
  out.caption =
      tr("Gravity removed: {candidate}.", {{"candidate", candidate_words(c, lines->estimator)}}) +
      " " + both;
  out.how_to_read =
      tr("Each direction has its own line, through the runs that travel far enough for ripple to "
         "average out and lie beyond the Stribeck dip. Parallel lines with a gap mean friction "
         "that differs between the directions, an offset of the torque signal, or a wrong gravity "
         "torque; lines of different slope mean different viscous friction.");
  out.alt = (wording::has_motor_side(c.manifest)
                 ? tr("Friction against the magnitude of the motor speed, forward and backward, "
                      "each with a straight line.")
                 : tr("Friction against the magnitude of the joint speed, forward and backward, "
                      "each with a straight line.")) +
            " " + both;
  return out;
}

namespace {

render::figure::Series markers(const std::string& label, std::vector<double> x,
                               std::vector<double> y) {
  render::figure::Series s = line(label, std::move(x), std::move(y), render::figure::palette::blue);
  s.style = render::figure::LineStyle::none;
  s.marker = render::figure::Marker::circle;
  s.marker_size_px = 12.0;
  return s;
}

render::figure::Panel over_load(const method::viscous::LoadDependenceResult& r,
                                const wording::AxisScale& scale) {
  const double viscous = r.viscous_Nms_rad ? r.viscous_Nms_rad->value : 0.0;
  std::vector<double> load;
  std::vector<double> friction;
  for (const method::viscous::LoadPoint& p : r.points) {
    load.push_back(scale(p.load_Nm));
    friction.push_back(scale(p.friction_Nm - viscous * p.speed_rad_s));
  }
  render::figure::Panel panel;
  panel.x.title = wording::axis_title(tr("magnitude of the gravity torque"), scale);
  panel.y.title = wording::axis_title(
      r.viscous_Nms_rad ? tr("friction minus its viscous part") : tr("friction T_{{f}}"), scale);
  add_visible(panel, markers(tr("(T(+) − T(−)) / 2 at equal angle"), load, friction));
  const auto fitted = [&](double at) { return scale(r.unloaded_Nm.value + r.per_load.value * at); };
  const std::vector<double> ends{r.lowest_load_Nm, r.highest_load_Nm};
  add_visible(panel, line(tr("fit"), shown(ends, scale), {fitted(ends[0]), fitted(ends[1])},
                          render::figure::palette::vermilion, 4.0));
  return panel;
}

render::figure::Panel over_angle(const calibration::Calibration& c,
                                 const wording::AxisScale& scale) {
  std::vector<double> angle;
  std::vector<double> friction;
  std::vector<double> fit;
  for (const method::viscous::LoadPoint& p : c.load_dependence.points) {
    angle.push_back(wording::degrees()(p.q_rad));
    friction.push_back(scale(p.friction_Nm));
    fit.push_back(scale(p.fit_Nm));
  }
  render::figure::Panel panel;
  panel.x.title = wording::axis_title(tr("joint angle q"), wording::degrees());
  panel.y.title = wording::axis_title(tr("friction T_{{f}}"), scale);
  add_visible(panel, markers(tr("(T(+) − T(−)) / 2 at equal angle"), angle, friction));
  add_visible(panel, line(tr("fit"), angle, fit, render::figure::palette::vermilion, 4.0));
  panel.show_legend = false;
  return panel;
}

}  // namespace

std::optional<ReportFigure> load_dependence_figure(const calibration::Calibration& c) {
  const method::viscous::LoadDependenceResult& r = c.load_dependence;
  if (!r.examined || r.points.empty()) return std::nullopt;
  wording::Extent friction;
  for (const method::viscous::LoadPoint& p : r.points) friction.add(p.friction_Nm);
  const wording::AxisScale scale = wording::prefixed("N·m", friction.largest());
  ReportFigure out;
  out.id = "fig-load-dependence";
  out.is_primary = breaks_any(
      c, {"friction_by_load", "friction_by_load_slope", "friction_by_angle",
          "friction_by_angle_slope", "torque_out_of_proportion", "slope_out_of_proportion"});
  out.title = tr("Friction against load");
  out.stage = "friction_parameters";
  out.figure.panels.push_back(over_load(r, scale));
  if (out.figure.panels.front().series.empty()) return std::nullopt;
  out.figure.panels.push_back(over_angle(c, scale));
  out.figure.height_px = 1400;
  const double percent = 100 * r.per_load.value;
  const double low = 100 * r.per_load.low;
  const double high = 100 * r.per_load.high;
  out.caption =
      r.found ? tr("Friction grows with the load, by {percent:.3g} % of the gravity torque "
                   "({low:.3g} to {high:.3g} %).",
                   {{"percent", percent}, {"low", low}, {"high", high}})
              : tr("Friction does not visibly grow with the load: {percent:.3g} % of the gravity "
                   "torque ({low:.3g} to {high:.3g} %).",
                   {{"percent", percent}, {"low", low}, {"high", high}});
  out.how_to_read =
      tr("Half the difference between the two directions at equal angle is friction, whatever "
         "gravity is. Points along a rising line mean friction that grows with the load; in the "
         "lower panel it is then smallest where the gravity torque passes zero. A pattern over the "
         "angle that the fit misses means friction that depends on the angle itself.");
  out.alt = tr("Friction against the gravity torque from {lowest} to {highest}, and against the "
               "joint angle.",
               {{"lowest", wording::with_unit(r.lowest_load_Nm, scale, 3)},
                {"highest", wording::with_unit(r.highest_load_Nm, scale, 3)}}) +
            " " + out.caption;
  return out;
}

}  // namespace tribolog::figures
