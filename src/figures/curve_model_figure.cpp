#include "figures/curve_model_figure.h"

#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "figures/folded_curves.h"
#include "figures/plot_data.h"
#include "wording/number_text.h"
#include "wording/shaft.h"

namespace tribolog::figures {
namespace {

namespace colour = render::palette;
using render::LineStyle;

constexpr double wide_range = 30.0;  // fastest over slowest: a logarithmic axis shows the dip
constexpr double chosen_px = 5.0;
constexpr double other_px = 2.5;
constexpr double circle_px = 31.0;
constexpr double diamond_px = 14.0;

struct LawStyle {
  render::Colour colour;
  LineStyle style;
};

LawStyle style_of(CurveLaw law) {
  constexpr std::array<LawStyle, 5> styles{{{colour::grey, LineStyle::dot},
                                            {colour::green, LineStyle::dash},
                                            {colour::orange, LineStyle::dash_dot},
                                            {colour::purple, LineStyle::dash_dot_dot},
                                            {colour::black, LineStyle::solid}}};
  return styles[static_cast<std::size_t>(law)];
}

render::Panel curves_panel(const Calibration& c, const AxisScale& scale) {
  const CurveModelChoice& choice = c.curve_model;
  render::Panel panel;
  panel.x.title = "size of " + speed_quantity(c.manifest) + " [rad/s]";
  panel.y.title = axis_title("friction along the motion T_{f}", scale);
  const Extent speeds = extent_of(choice.curve_speed_rad_s);
  if (speeds.low > 0 && speeds.high > wide_range * speeds.low) {
    panel.x.logarithmic = true;
    panel.x.minimum = 0.8 * speeds.low;
    panel.x.maximum = 1.25 * speeds.high;
  }
  add_folded_curve(panel, c, choice.curve, scale, true);
  panel.error_bars.clear();  // those are figure 21's
  for (render::Series& series : panel.series) {
    // To be seen beside the lines, and both where the directions agree.
    const bool is_backward = series.label.find("backward") != std::string::npos;
    series.marker_size_px = is_backward ? diamond_px : circle_px;
  }
  for (const CurveModelTrial& trial : choice.ladder) {
    if (!trial.excluded_because.empty()) continue;
    const bool is_chosen = trial.model.law == choice.chosen.law;
    const LawStyle style = style_of(trial.model.law);
    add_visible(panel, line(in_words(trial.model.law) + (is_chosen ? " (chosen)" : ""),
                            choice.curve_speed_rad_s, shown(trial.curve_Nm, scale), style.colour,
                            is_chosen ? chosen_px : other_px, style.style));
  }
  return panel;
}

render::Panel errors_panel(const CurveModelChoice& choice) {
  Extent errors;
  for (const CurveModelTrial& t : choice.ladder) {
    if (!t.excluded_because.empty()) continue;
    errors.add(t.held_out_rms_Nm);
    errors.add(t.training_rms_Nm);
  }
  const AxisScale scale = prefixed("N·m", errors.largest());
  render::Panel panel;
  panel.x.title = "parameters of the model";
  panel.x.counts = true;
  panel.y.title = axis_title("rms error", scale);
  panel.y.minimum = 0;
  render::Series held = line("at speeds held out: decides", {}, {}, colour::vermilion);
  render::Series training = line("on its own data", {}, {}, colour::blue, 2.5, LineStyle::dash);
  held.marker = render::Marker::circle;
  training.marker = render::Marker::square;
  held.marker_size_px = training.marker_size_px = 13.0;
  for (const CurveModelTrial& t : choice.ladder) {
    if (!t.excluded_because.empty()) continue;
    const double parameters = t.model.parameters();
    held.x.push_back(parameters);
    training.x.push_back(parameters);
    held.y.push_back(scale(t.held_out_rms_Nm));
    training.y.push_back(scale(t.training_rms_Nm));
    if (t.model.law == choice.chosen.law) {
      add_visible(panel, render::PointLabel{parameters, held.y.back(), "chosen", colour::vermilion,
                                            render::Marker::none});
    }
  }
  const Extent counts = extent_of(held.x);
  panel.x.minimum = counts.low - 0.5;
  panel.x.maximum = counts.high + 0.5;
  add_visible(panel, std::move(held));
  add_visible(panel, std::move(training));
  return panel;
}

}  // namespace

std::optional<ReportFigure> curve_model_figure(const Calibration& c) {
  const CurveModelChoice& choice = c.curve_model;
  const ViscousCurve* curve = c.viscous.find(choice.curve);
  if (!choice.chosen_any || curve == nullptr) return std::nullopt;
  const CurveModelTrial* chosen = choice.find(choice.chosen.law);
  if (chosen == nullptr) return std::nullopt;
  ReportFigure out;
  out.id = "fig-curve-models";
  out.title = "Which friction model the curve carries";
  out.stage = "friction_parameters";
  out.figure.panels.push_back(
      curves_panel(c, prefixed("N·m", extent_of(curve->friction_Nm).largest())));
  if (out.figure.panels.front().series.empty()) return std::nullopt;
  out.figure.panels.push_back(errors_panel(choice));
  out.figure.height_px = 1400;
  const std::string error = size_words(chosen->held_out_rms_Nm, torque_floor_Nm, "N·m");
  out.caption = fmt::format(
      "Chosen: {} ({}), with an error of {} at speeds held out.", in_words(choice.chosen),
      counted(static_cast<std::size_t>(choice.chosen.parameters()), "parameter"), error);
  out.how_to_read =
      "Above, the models on the curve; where a term for load or direction was taken up they are "
      "drawn at the mean load and the mean of the directions, and the points scatter about them. "
      "Below, at the same speeds: the error on a model's own data falls with every parameter and "
      "says nothing; the error at speeds that took no part in the fit stops falling, or rises, "
      "where the parameters "
      "begin to follow noise. The simplest model within one standard error of the best is taken.";
  out.alt = fmt::format(
      "Friction curves of {} over the measured curve, and their errors over the "
      "number of parameters. Chosen: {}, {} at speeds held out.",
      counted(choice.ladder.size(), "model"), in_words(choice.chosen), error);
  return out;
}

}  // namespace tribolog::figures
