#include "figures/direction_lines_figure.h"

#include <utility>

#include <fmt/format.h>

#include "figures/estimator_style.h"
#include "figures/folded_curves.h"
#include "figures/plot_data.h"
#include "figures/run_curves.h"
#include "wording/number_text.h"
#include "wording/shaft.h"

namespace tribolog::figures {
namespace {

void add_line(render::Panel& panel, const std::optional<DirectionLine>& l, bool rising,
              const AxisScale& scale) {
  if (!l) return;
  const auto at = [&](double w) {
    return scale(l->coulomb_Nm.value + l->viscous_Nms_rad.value * w);
  };
  add_visible(
      panel,
      line(rising ? "line, forward" : "line, backward", {l->slowest_rad_s, l->fastest_rad_s},
           {at(l->slowest_rad_s), at(l->fastest_rad_s)}, rising ? rising_colour : falling_colour,
           4.0, rising ? render::LineStyle::solid : render::LineStyle::dash));
}

std::string words(const std::optional<DirectionLine>& l, const char* direction) {
  if (!l) return fmt::format(" {}: too few speeds.", direction);
  return fmt::format(
      " {}: Coulomb {}, viscous {}, from {}.", direction,
      with_interval(l->coulomb_Nm, prefixed("N·m", l->coulomb_Nm.value)),
      with_interval(l->viscous_Nms_rad, prefixed("N·m·s/rad", l->viscous_Nms_rad.value)),
      counted(l->runs, "run"));
}

}  // namespace

std::optional<ReportFigure> direction_lines_figure(const Calibration& c) {
  if (c.viscous.from_sweep) return std::nullopt;
  const CurveDirectionLines* lines = c.direction_lines.find(stated_estimator);
  if (lines == nullptr) lines = c.direction_lines.find(c.selection.recommended);
  if (lines == nullptr || (!lines->rising && !lines->falling)) return std::nullopt;
  const ViscousCurve* curve = c.viscous.find(lines->estimator);
  if (curve == nullptr) return std::nullopt;
  const AxisScale scale = prefixed("N·m", extent_of(curve->friction_Nm).largest());
  ReportFigure out;
  out.id = "fig-directions";
  out.title = "Friction of each direction";
  out.stage = "friction_parameters";
  render::Panel panel;
  panel.x.title = "size of " + speed_quantity(c.manifest) + " [rad/s]";
  panel.y.title = axis_title("friction along the motion T_{f}", scale);
  add_folded_curve(panel, c, lines->estimator, scale, true);
  add_line(panel, lines->rising, true, scale);
  add_line(panel, lines->falling, false, scale);
  if (panel.series.empty()) return std::nullopt;
  out.figure.panels.push_back(std::move(panel));
  out.caption = fmt::format("Gravity removed: {}.{}{}", candidate_words(c, lines->estimator),
                            words(lines->rising, "Forward"), words(lines->falling, "Backward"));
  out.how_to_read =
      "Each direction has its own line, through the runs that travel far enough for ripple to "
      "average out and lie beyond the Stribeck dip. Parallel lines apart are friction that is not "
      "the same in both directions, an offset of the torque signal, or a wrong gravity torque; "
      "lines of different slope are different viscous friction.";
  out.alt = fmt::format(
      "Friction over the size of the {} speed, forward and backward, each with a "
      "straight line.{}{}",
      shaft(c.manifest), words(lines->rising, "Forward"), words(lines->falling, "Backward"));
  return out;
}

}  // namespace tribolog::figures
