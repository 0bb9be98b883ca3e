#include "figures/parameter_figures.h"

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

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

}  // namespace tribolog::figures
