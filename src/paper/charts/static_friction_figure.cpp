#include "paper/charts/static_friction_figure.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "figures/plot_data.h"
#include "paper/charts/static_law_panel.h"

namespace tribolog::paper {
namespace {

constexpr double shown_stribeck_speeds = 8;

/// Next to rest, as a share of the Stribeck velocity: the law's limit from one side.
constexpr double beside_rest = 1e-9;

StaticLevels levels_of(const StribeckFriction& friction) {
  const StribeckCurve::Parameters& curve = friction.curve().parameters();
  return {curve.static_Nm,
          curve.coulomb_Nm,
          friction.parameters().viscous_Nms_rad,
          curve.stribeck_speed_rad_s,
          "ω_{s}",
          "T_{ω}"};
}

render::Panel panel_of(const StribeckFriction& friction, const StaticLevels& levels) {
  const double largest = shown_stribeck_speeds * levels.fall_rad_s;
  const double rest = beside_rest * levels.fall_rad_s;
  const figures::AxisScale speeds = figures::prefixed("rad/s", largest);
  const StaticLaw law = [&](double speed) { return friction.torque_Nm(speed); };
  render::Panel panel = static_law_panel(largest, std::max(levels.static_Nm, law(largest)));
  add_levels(panel, levels, largest);
  render::Series at_rest = figures::line("at rest: equal to the applied torque, up to ±T_{brk}",
                                         {0.0, 0.0}, {-levels.static_Nm, levels.static_Nm},
                                         render::palette::black, 3.0, render::LineStyle::dot);
  at_rest.marker = render::Marker::circle;
  render::Series forward = law_series(law, rest, largest, speeds);
  forward.label = "in motion, eq. (1)";
  panel.series.push_back(law_series(law, -largest, -rest, speeds));
  panel.series.push_back(std::move(forward));
  panel.series.push_back(std::move(at_rest));
  return panel;
}

}  // namespace

ReportFigure static_friction_figure(const StribeckFriction& friction) {
  const StaticLevels levels = levels_of(friction);
  const std::string speed = parameter_text(levels.fall_rad_s, "rad/s");
  ReportFigure out;
  out.number = 1;
  out.id = "fig-01-static-discontinuous";
  out.title = "Static friction, discontinuous at rest";
  out.caption = fmt::format(
      "Equation (1): {}, Stribeck velocity {}. The paper prints no values; these parameters are "
      "ours, at the size of its joint.",
      levels_words(levels), speed);
  out.how_to_read =
      "At rest the law is no function of speed: friction equals the applied torque, whatever it "
      "is, up to ±T_brk (dotted). In motion it starts at T_brk and falls towards the Coulomb "
      "torque: at the Stribeck velocity 37 % of the excess is left. Then the viscous part leads it "
      "upwards along the dashed line. Between −T_brk and +T_brk a solver cannot tell from the "
      "speed what friction is, which is why figure 2 and the models with memory exist.";
  out.alt = fmt::format(
      "Friction torque against motor speed. It jumps at rest from −{0} to +{0}, falls on both "
      "sides within some {1} towards a line that starts at {2} and rises with speed.",
      parameter_text(levels.static_Nm, "N·m"), speed, parameter_text(levels.coulomb_Nm, "N·m"));
  out.figure.id = out.id;
  out.figure.title = out.title;
  out.figure.panels.push_back(panel_of(friction, levels));
  return out;
}

}  // namespace tribolog::paper
