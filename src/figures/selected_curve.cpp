#include "figures/selected_curve.h"

#include <cmath>
#include <string>
#include <utility>

#include "figures/run_curves.h"
#include "wording/labels.h"
#include "wording/number_text.h"
#include "wording/tr.h"

namespace tribolog::figures {
namespace {

using wording::tr;

constexpr double wide_range = 30.0;  // fastest over slowest: a logarithmic axis shows the dip

/// Of each fitted law a sentence, with a space before it.
std::string fit_words(const calibration::Calibration& calibration) {
  const method::selection::FrictionParametersResult& friction = calibration.friction;
  std::string text;
  if (friction.waiboer && friction.waiboer->converged) {
    text += " " + tr("The scatter about Waiboer's law is {scatter}.",
                     {{"scatter", wording::size_words(friction.waiboer->residual_Nm,
                                                      wording::torque_floor_Nm, "N·m")}});
  }
  return text;
}

/// Begins with a space; empty without the paper's rule.
std::string paper_words(const calibration::Calibration& calibration) {
  const auto estimator = calibration.selection.paper_rule;
  if (!estimator) return {};
  return " " + tr("The paper's rule selects {candidate}.",
                  {{"candidate", candidate_words(calibration, *estimator)}});
}

std::optional<render::figure::Panel> residual_panel(const calibration::Calibration& calibration,
                                                    const render::figure::Axis& speeds) {
  const method::viscous::ViscousCurve* curve =
      calibration.viscous.find(calibration.selection.recommended);
  if (curve == nullptr || calibration.model.law.empty()) return std::nullopt;
  const std::vector<double> left_Nm = left_by_law(calibration, *curve);
  const wording::AxisScale scale = wording::prefixed("N·m", wording::extent_of(left_Nm).largest());
  render::figure::Panel panel;
  panel.x = speeds;
  panel.y.title = wording::axis_title(tr("left by the law"), scale);
  add_residuals(panel, calibration, left_Nm, scale);
  if (panel.series.empty()) return std::nullopt;
  return panel;
}

}  // namespace

std::optional<ReportFigure> selected_curve_figure(const calibration::Calibration& calibration) {
  const method::selection::SelectionResult& selection = calibration.selection;
  wording::Extent speeds;
  wording::Extent friction;
  for (const method::viscous::ConstantSpeedRun& run : calibration.viscous.runs) {
    if (run.speed_rad_s != 0.0) speeds.add(std::abs(run.speed_rad_s));
  }
  for (const auto estimator : {selection.recommended, selection.paper_rule}) {
    if (const method::viscous::ViscousCurve* curve = calibration.viscous.find(estimator))
      friction.add(curve->friction_Nm);
  }
  if (speeds.empty || friction.empty) return std::nullopt;

  ReportFigure out;
  out.paper_number = 21;
  out.id = "fig-21-selected-curve";
  out.title = tr("Selected friction curve");
  out.stage = "friction_parameters";
  const wording::AxisScale scale = wording::prefixed("N·m", friction.largest());
  render::figure::Panel panel;
  panel.x.title = wording::speed_size(calibration.manifest) + " [rad/s]";
  panel.y.title = wording::axis_title(tr("friction along the motion T_{{f}}"), scale);
  if (!calibration.viscous.from_sweep && speeds.high > wide_range * speeds.low) {
    panel.x.logarithmic = true;
    panel.x.minimum = 0.8 * speeds.low;
    panel.x.maximum = 1.25 * speeds.high;
  }
  const bool bins = calibration.viscous.from_sweep;
  // Lines lie under the markers; where everything is a marker, small ones lie on large ones.
  if (!bins) add_folded_reference(panel, calibration, speeds, scale);
  add_fitted_laws(panel, calibration, scale);
  add_folded_curve(panel, calibration, selection.recommended, scale, true);
  if (selection.paper_rule != selection.recommended) {
    add_folded_curve(panel, calibration, selection.paper_rule, scale, false);
  }
  if (bins) add_folded_reference(panel, calibration, speeds, scale);
  if (panel.series.empty()) return std::nullopt;
  out.figure.panels.push_back(std::move(panel));
  if (auto residuals = residual_panel(calibration, out.figure.panels.front().x)) {
    out.figure.panels.push_back(std::move(*residuals));
    out.figure.height_px = 1400;
    out.figure.panels_share_x = true;
  }

  const std::string recommended =
      selection.recommended ? candidate_words(calibration, *selection.recommended) : std::string();
  const std::string rest = paper_words(calibration) + fit_words(calibration);
  out.caption =
      (!selection.recommended ? tr("Friction with gravity removed; no estimator is recommended.")
                              : tr("Friction with gravity removed; recommended: {candidate}.",
                                   {{"candidate", recommended}})) +
      rest;
  out.how_to_read =
      calibration.viscous.from_sweep
          ? tr("Each marker is the friction at one angle of the sweep, at the joint's speed there. "
               "Forward and backward should coincide within their bars; two branches at the "
               "same speed mean that friction also depends on load or angle, and then no law of "
               "speed alone fits.")
          : tr("Forward and backward runs are folded onto each other. With the right mass they "
               "coincide within their bars (drawn where longer than a marker) and lie on the "
               "reference; a constant gap between them is twice the error in gravity torque. The "
               "law should pass through the points; what it leaves, below, should have no "
               "pattern.");
  const std::string slowest = wording::significant(speeds.low, 3);
  const std::string fastest = wording::with_unit(speeds.high, wording::AxisScale{1.0, "rad/s"}, 3);
  out.alt = (!selection.recommended
                 ? tr("Friction torque against speed from {slowest} to {fastest}; no estimator is "
                      "recommended.",
                      {{"slowest", slowest}, {"fastest", fastest}})
                 : tr("Friction torque against speed from {slowest} to {fastest}; recommended: "
                      "{candidate}.",
                      {{"slowest", slowest}, {"fastest", fastest}, {"candidate", recommended}})) +
            rest;
  return out;
}

}  // namespace tribolog::figures
