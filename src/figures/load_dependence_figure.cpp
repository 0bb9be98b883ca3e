#include "figures/load_dependence_figure.h"

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "figures/estimator_style.h"
#include "figures/plot_data.h"
#include "wording/axis_scale.h"
#include "wording/number_text.h"
#include "wording/shaft.h"

namespace tribolog::figures {
namespace {

render::Series markers(const std::string& label, std::vector<double> x, std::vector<double> y) {
  render::Series s = line(label, std::move(x), std::move(y), render::palette::blue);
  s.style = render::LineStyle::none;
  s.marker = render::Marker::circle;
  s.marker_size_px = 12.0;
  return s;
}

render::Panel over_load(const LoadDependenceResult& r, const AxisScale& scale) {
  const double viscous = r.viscous_Nms_rad ? r.viscous_Nms_rad->value : 0.0;
  std::vector<double> load;
  std::vector<double> friction;
  for (const LoadPoint& p : r.points) {
    load.push_back(scale(p.load_Nm));
    friction.push_back(scale(p.friction_Nm - viscous * p.speed_rad_s));
  }
  render::Panel panel;
  panel.x.title = axis_title("size of the gravity torque", scale);
  panel.y.title =
      axis_title(r.viscous_Nms_rad ? "friction less its viscous part" : "friction T_{f}", scale);
  add_visible(panel, markers("(T(+) − T(−)) / 2 at equal angle", load, friction));
  const auto fitted = [&](double at) { return scale(r.unloaded_Nm.value + r.per_load.value * at); };
  const std::vector<double> ends{r.lowest_load_Nm, r.highest_load_Nm};
  add_visible(panel, line("fit", shown(ends, scale), {fitted(ends[0]), fitted(ends[1])},
                          render::palette::vermilion, 4.0));
  return panel;
}

render::Panel over_angle(const Calibration& c, const AxisScale& scale) {
  std::vector<double> angle;
  std::vector<double> friction;
  std::vector<double> fit;
  for (const LoadPoint& p : c.load_dependence.points) {
    angle.push_back(degrees()(p.q_rad));
    friction.push_back(scale(p.friction_Nm));
    fit.push_back(scale(p.fit_Nm));
  }
  render::Panel panel;
  panel.x.title = "joint angle q [°]";
  panel.y.title = axis_title("friction T_{f}", scale);
  add_visible(panel, markers("(T(+) − T(−)) / 2 at equal angle", angle, friction));
  add_visible(panel, line("fit", angle, fit, render::palette::vermilion, 4.0));
  panel.show_legend = false;
  return panel;
}

}  // namespace

std::optional<ReportFigure> load_dependence_figure(const Calibration& c) {
  const LoadDependenceResult& r = c.load_dependence;
  if (!r.examined || r.points.empty()) return std::nullopt;
  Extent friction;
  for (const LoadPoint& p : r.points) friction.add(p.friction_Nm);
  const AxisScale scale = prefixed("N·m", friction.largest());
  ReportFigure out;
  out.id = "fig-load-dependence";
  out.title = "Friction against load";
  out.stage = "friction_parameters";
  out.figure.panels.push_back(over_load(r, scale));
  if (out.figure.panels.front().series.empty()) return std::nullopt;
  out.figure.panels.push_back(over_angle(c, scale));
  out.figure.height_px = 1400;
  const std::string slope =
      fmt::format("{:.3g} % of the gravity torque ({:.3g} to {:.3g} %)", 100 * r.per_load.value,
                  100 * r.per_load.low, 100 * r.per_load.high);
  out.caption = r.found ? "Friction grows with the load, by " + slope + "."
                        : "Friction does not visibly grow with the load: " + slope + ".";
  out.how_to_read =
      "Half the difference of the two directions at equal angle is friction, whatever gravity is. "
      "Points along a rising line are friction that grows with the load; below, it then has its "
      "least where gravity torque passes zero. A fit that misses a pattern over the angle means "
      "friction that depends on the angle itself.";
  out.alt = fmt::format(
      "Friction over the gravity torque from {} to {}, and over the joint angle. {}",
      with_unit(r.lowest_load_Nm, scale, 3), with_unit(r.highest_load_Nm, scale, 3), out.caption);
  return out;
}

}  // namespace tribolog::figures
