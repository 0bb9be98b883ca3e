#include "figures/selected_curve.h"

#include <cmath>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "figures/run_curves.h"
#include "wording/number_text.h"
#include "wording/shaft.h"

namespace tribolog::figures {
namespace {

constexpr double wide_range = 30.0;  // fastest over slowest: a logarithmic axis shows the dip

std::string fit_words(const calibration::Calibration& calibration) {
  const method::selection::FrictionParametersResult& friction = calibration.friction;
  std::string text;
  if (friction.coulomb_viscous) {
    const method::selection::CoulombViscousFit& law = *friction.coulomb_viscous;
    text += fmt::format(
        " Coulomb friction {}, viscous {} at the {}.",
        wording::with_interval(law.coulomb_Nm, wording::prefixed("N·m", law.coulomb_Nm.value)),
        wording::with_interval(law.viscous_Nms_rad,
                               wording::prefixed("N·m·s/rad", law.viscous_Nms_rad.value)),
        wording::shaft(calibration.manifest));
  }
  if (friction.waiboer && friction.waiboer->converged) {
    text += fmt::format(
        " The scatter about Waiboer's law is {}.",
        wording::size_words(friction.waiboer->residual_Nm, wording::torque_floor_Nm, "N·m"));
  }
  return text;
}

}  // namespace

std::optional<ReportFigure> selected_curve_figure(const calibration::Calibration& calibration) {
  const method::selection::SelectionResult& selection = calibration.selection;
  wording::Extent speeds;
  wording::Extent friction;
  for (const method::viscous::ConstantSpeedRun& run : calibration.viscous.runs) {
    if (run.speed_rad_s != 0.0) speeds.add(std::abs(run.speed_rad_s));
  }
  for (const std::string& name : {selection.recommended, selection.paper_rule}) {
    if (const method::viscous::ViscousCurve* curve = calibration.viscous.find(name))
      friction.add(curve->friction_Nm);
  }
  if (speeds.empty || friction.empty) return std::nullopt;

  ReportFigure out;
  out.number = 21;
  out.id = "fig-21-selected-curve";
  out.title = "Selected friction curve";
  out.stage = "friction_parameters";
  const wording::AxisScale scale = wording::prefixed("N·m", friction.largest());
  render::figure::Panel panel;
  panel.x.title = "size of " + wording::speed_quantity(calibration.manifest) + " [rad/s]";
  panel.y.title = wording::axis_title("friction along the motion T_{f}", scale);
  if (!calibration.viscous.from_sweep && speeds.high > wide_range * speeds.low) {
    panel.x.logarithmic = true;
    panel.x.minimum = 0.8 * speeds.low;
    panel.x.maximum = 1.25 * speeds.high;
  }
  const bool bins = calibration.viscous.from_sweep;
  // Lines lie under the markers; where everything is a marker, small ones lie on large ones.
  if (!bins) add_folded_reference(panel, calibration, speeds, scale);
  add_fitted_laws(panel, calibration.friction, scale);
  add_folded_curve(panel, calibration, selection.recommended, scale, true);
  if (selection.paper_rule != selection.recommended) {
    add_folded_curve(panel, calibration, selection.paper_rule, scale, false);
  }
  if (bins) add_folded_reference(panel, calibration, speeds, scale);
  if (panel.series.empty()) return std::nullopt;
  out.figure.panels.push_back(std::move(panel));

  const std::string paper = selection.paper_rule.empty()
                                ? std::string()
                                : fmt::format(" The paper's rule selects {}.",
                                              candidate_words(calibration, selection.paper_rule));
  const std::string recommended =
      selection.recommended.empty()
          ? std::string("no estimator is recommended")
          : "recommended: " + candidate_words(calibration, selection.recommended);
  out.caption = fmt::format("Friction with gravity removed; {}.{}{}", recommended, paper,
                            fit_words(calibration));
  out.how_to_read =
      calibration.viscous.from_sweep
          ? "Each marker is the friction at one angle of the sweep, at the joint's speed there. "
            "Forward and backward should coincide within their bars; two branches at the "
            "same speed mean that friction also depends on load or angle, and then no law of "
            "speed alone fits."
          : "Forward and backward runs are folded onto each other. With the right mass they "
            "coincide within their bars (drawn where longer than a marker) and lie on the "
            "reference; a constant gap between them is twice the error in gravity torque. The "
            "fitted laws should pass through the points without a pattern.";
  out.alt = fmt::format("Friction torque against speed from {} to {}; {}.{}{}",
                        wording::significant(speeds.low, 3),
                        wording::with_unit(speeds.high, wording::AxisScale{1.0, "rad/s"}, 3),
                        recommended, paper, fit_words(calibration));
  return out;
}

}  // namespace tribolog::figures
