#include "figures/lugre_loop.h"

#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "figures/estimator_style.h"
#include "figures/loop_panels.h"
#include "figures/plot_data.h"
#include "wording/number_text.h"

namespace tribolog::figures {
namespace {

constexpr double model_px = 3.0;
constexpr double zero_px = 1.5;

render::Panel loop_panel(const LoopView& view, const LuGreLoop& loop, const AxisScale& torque) {
  render::Panel panel;
  panel.x.title = axis_title("joint angle from the loop's centre q − q_{0}",
                             AxisScale{view.angle.factor, view.angle.unit});
  panel.y.title = axis_title("driving torque T", torque);
  const LoopTrace& trace = *view.trace;
  add_visible(panel, line("measured", shown(trace.q_rad, view.angle),
                          shown(trace.torque_Nm, torque), cloud, cloud_px));
  add_visible(panel, line("LuGre fit", shown(trace.q_rad, view.angle),
                          shown(loop.torque_Nm, torque), render::palette::blue, model_px));
  return panel;
}

render::Panel misfit_panel(const LoopView& view, const LoopMisfit& misfit, double residual_Nm,
                           const AxisScale& torque) {
  render::Panel panel;
  panel.x.title = axis_title("joint angle from the loop's centre q − q_{0}",
                             AxisScale{view.angle.factor, view.angle.unit});
  panel.y.title = axis_title("mean of T − fit", torque);
  const std::vector<double> q = shown(misfit.q_rad, view.angle);
  if (!q.empty()) {
    const std::vector<double> high(q.size(), torque(residual_Nm));
    const std::vector<double> low(q.size(), -torque(residual_Nm));
    panel.bands.push_back({"scatter of single samples", q, low, high, faded(cloud, 120)});
    add_visible(panel,
                line("", {q.front(), q.back()}, {0.0, 0.0}, render::palette::black, zero_px));
  }
  add_visible(panel,
              line("while the angle grows", q, shown(misfit.rising_Nm, torque), rising_colour));
  add_visible(panel, line("while it falls", q, shown(misfit.falling_Nm, torque), falling_colour,
                          2.5, render::LineStyle::dash));
  return panel;
}

/// "σ₀ 465.4 ± 1.2 N·m/rad and T_s 0.884 ± 0.002 N·m"
std::string found_words(const LuGreFit& fit) {
  std::vector<std::string> found;
  const auto add = [&](const char* name, const char* symbol, const char* unit) {
    if (const auto e = fit.shown(name)) {
      found.push_back(std::string(symbol) + " " + with_interval(*e, AxisScale{1.0, unit}));
    }
  };
  add("bristle_stiffness_Nm_rad", "σ₀", "N·m/rad");
  add("bristle_damping_Nms_rad", "σ₁", "N·m·s/rad");
  add("static_Nm", "Ts", "N·m");
  add("coulomb_Nm", "Tc", "N·m");
  add("stribeck_speed_rad_s", "ωs", "rad/s");
  return found.empty() ? "no parameter is shown" : listed(found);
}

}  // namespace

std::optional<ReportFigure> lugre_loop_figure(const Calibration& calibration) {
  const auto& fit = calibration.hysteresis.lugre;
  const auto view = loop_view(calibration);
  if (!view || !fit || !fit->converged || view->model_torque_Nm == nullptr) return std::nullopt;
  const LuGreLoop& loop = fit->loops.front();
  Extent misfit;
  misfit.add(loop.misfit.rising_Nm);
  misfit.add(loop.misfit.falling_Nm);
  ReportFigure out;
  out.id = "fig-lugre-loop";
  out.title = "LuGre fitted to the hysteresis loop";
  out.stage = "friction_parameters";
  const AxisScale torque = prefixed("N·m", extent_of(view->trace->torque_Nm).largest());
  const AxisScale small = prefixed("N·m", std::max(misfit.largest(), loop.residual_Nm));
  out.figure.panels.push_back(loop_panel(*view, loop, torque));
  if (!misfit.empty) {
    out.figure.panels.push_back(misfit_panel(*view, loop.misfit, loop.residual_Nm, small));
    out.figure.panels_share_x = true;
    out.figure.height_px = 1500;
  }
  const std::string which =
      fit->loops.size() > 1
          ? fmt::format(" The first of {} loops that were fitted together.", fit->loops.size())
          : "";
  const std::string scatter = size_words(loop.residual_Nm, torque_floor_Nm, "N·m");
  const std::string left = size_words(misfit.largest(), torque_floor_Nm, "N·m");
  out.caption = fmt::format(
      "From the loop alone: {}. Single samples scatter about the fit by {}; averaged over the "
      "angle, at most {} is left.{}",
      found_words(*fit), scatter, left, which);
  out.how_to_read =
      "Below, the mean should lie far inside the band and cross zero often. A bow or a step that "
      "both directions repeat is friction that this model does not have; opposite signs of the two "
      "directions are a loop too wide or too narrow.";
  out.alt = fmt::format(
      "Measured torque over joint angle with the fitted LuGre loop on it, and the mean of what the "
      "fit leaves, at most {} against a scatter of {}.",
      left, scatter);
  return out;
}

}  // namespace tribolog::figures
