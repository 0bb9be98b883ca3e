#include <algorithm>
#include <functional>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "base/requirements.h"
#include "figures/report_figure.h"
#include "paper/charts/paper_charts.h"
#include "render/figure/figure.h"
#include "wording/axis_scale.h"
#include "wording/number_text.h"
#include "wording/tr.h"

namespace tribolog::paper::charts {

// What the charts of eq. (1) and (2) share: friction over signed speed, with its levels marked.

namespace {

/// Friction torque [N·m] by speed [rad/s]; odd.
using StaticLaw = std::function<double(double)>;

/// Numbers by which both laws are known.
struct StaticLevels {
  double static_Nm{};
  double coulomb_Nm{};
  double viscous_Nms_rad{};
  double fall_rad_s{};       ///< Speed at which the Stribeck effect is down to 1/e of itself.
  std::string fall_symbol;   ///< With the markup of render/figure/figure.h.
  std::string slope_symbol;  ///< Likewise.
};

using wording::AxisScale;
using wording::prefixed;
using wording::tr;

constexpr double curve_px = 4.0;
constexpr double part_px = 3.0;

void add_line(render::figure::Panel& panel, render::figure::ReferenceLine::Direction direction,
              double at, const std::string& text) {
  panel.reference_lines.push_back({direction, at, text});
}

/// A parameter as it was set: "0.884 N·m", "5 rad/s", "2.4 mN·m·s/rad". Torques keep their unit, so
/// that levels compare at a glance; others take a prefix.
std::string parameter_text(double value, const std::string& si_unit) {
  const wording::AxisScale scale =
      si_unit == "N·m" ? wording::AxisScale{1.0, si_unit} : wording::prefixed(si_unit, value);
  return fmt::format("{:.4g} {}", scale(value), scale.unit);
}

/// An empty panel with its axes: speed as far as `largest_rad_s` on both sides.
render::figure::Panel static_law_panel(double largest_rad_s, double largest_Nm) {
  const wording::AxisScale speeds = wording::prefixed("rad/s", largest_rad_s);
  constexpr double margin = 1.25;  // room for the legend
  render::figure::Panel panel;
  panel.x.title = wording::axis_title(tr("motor speed ω"), speeds);
  panel.x.minimum = speeds(-largest_rad_s);
  panel.x.maximum = speeds(largest_rad_s);
  panel.y.title = tr("friction T_{{f}} [N·m]");
  panel.y.minimum = -margin * largest_Nm;
  panel.y.maximum = margin * largest_Nm;
  return panel;
}

/// The law between two speeds, as many points as a smooth line needs.
/// @param speeds the axis of the panel.
render::figure::Series law_series(const StaticLaw& law, double from_rad_s, double to_rad_s,
                                  const wording::AxisScale& speeds) {
  constexpr int pieces = 600;
  std::vector<double> x;
  std::vector<double> y;
  for (int i = 0; i <= pieces; ++i) {
    const double share = static_cast<double>(i) / pieces;
    const double speed = (1 - share) * from_rad_s + share * to_rad_s;
    x.push_back(speeds(speed));
    y.push_back(law(speed));
  }
  return figures::line("", std::move(x), std::move(y), render::figure::palette::blue, curve_px);
}

/// Adds lines at the static and Coulomb torques and at the fall of the Stribeck effect, on both
/// sides of rest, and the viscous part on top of the Coulomb torque as a dashed line.
void add_levels(render::figure::Panel& panel, const StaticLevels& levels, double largest_rad_s) {
  using Direction = render::figure::ReferenceLine::Direction;
  const wording::AxisScale speeds = wording::prefixed("rad/s", largest_rad_s);
  const std::string fall =
      fmt::format("{} = {}", levels.fall_symbol, parameter_text(levels.fall_rad_s, "rad/s"));
  add_line(panel, Direction::horizontal, levels.static_Nm,
           "T_{brk} = " + parameter_text(levels.static_Nm, "N·m"));
  add_line(panel, Direction::horizontal, levels.coulomb_Nm,
           "T_{c} = " + parameter_text(levels.coulomb_Nm, "N·m"));
  add_line(panel, Direction::horizontal, -levels.coulomb_Nm, "−T_{c}");
  add_line(panel, Direction::horizontal, -levels.static_Nm, "−T_{brk}");
  add_line(panel, Direction::vertical, speeds(levels.fall_rad_s), fall);
  add_line(panel, Direction::vertical, speeds(-levels.fall_rad_s), "−" + levels.fall_symbol);
  const auto viscous = [&](double side, const std::string& label) {
    const double end_Nm = levels.coulomb_Nm + levels.viscous_Nms_rad * largest_rad_s;
    panel.series.push_back(figures::line(
        label, {0.0, side * speeds(largest_rad_s)}, {side * levels.coulomb_Nm, side * end_Nm},
        render::figure::palette::vermilion, part_px, render::figure::LineStyle::dash));
  };
  viscous(-1, "");
  viscous(+1, tr("T_{{c}} + {slope_symbol} |ω|, slope {slope_symbol} = {viscous_slope}",
                 {{"slope_symbol", levels.slope_symbol},
                  {"viscous_slope", parameter_text(levels.viscous_Nms_rad, "N·m·s/rad")}}));
}

constexpr double shown_stribeck_speeds = 8;

/// Next to rest, as a share of the Stribeck velocity: the law's limit from one side.
constexpr double beside_rest = 1e-9;

StaticLevels levels_of(const friction::StribeckFriction& friction) {
  const friction::StribeckCurve::Parameters& curve = friction.curve().parameters();
  return {curve.static_Nm,
          curve.coulomb_Nm,
          friction.parameters().viscous_Nms_rad,
          curve.stribeck_speed_rad_s,
          "ω_{s}",
          "T_{ω}"};
}

render::figure::Panel panel_of(const friction::StribeckFriction& friction,
                               const StaticLevels& levels) {
  const double largest = shown_stribeck_speeds * levels.fall_rad_s;
  const double rest = beside_rest * levels.fall_rad_s;
  const wording::AxisScale speeds = wording::prefixed("rad/s", largest);
  const StaticLaw law = [&](double speed) { return friction.torque_Nm(speed); };
  render::figure::Panel panel = static_law_panel(largest, std::max(levels.static_Nm, law(largest)));
  add_levels(panel, levels, largest);
  render::figure::Series at_rest =
      figures::line(tr("at rest: equal to the applied torque, up to ±T_{{brk}}"), {0.0, 0.0},
                    {-levels.static_Nm, levels.static_Nm}, render::figure::palette::black, 3.0,
                    render::figure::LineStyle::dot);
  at_rest.marker = render::figure::Marker::circle;
  render::figure::Series forward = law_series(law, rest, largest, speeds);
  forward.label = tr("in motion, eq. (1)");
  panel.series.push_back(law_series(law, -largest, -rest, speeds));
  panel.series.push_back(std::move(forward));
  panel.series.push_back(std::move(at_rest));
  return panel;
}

}  // namespace

figures::ReportFigure static_friction_figure(const friction::StribeckFriction& friction) {
  const StaticLevels levels = levels_of(friction);
  const std::string static_torque = parameter_text(levels.static_Nm, "N·m");
  const std::string coulomb_torque = parameter_text(levels.coulomb_Nm, "N·m");
  const std::string speed = parameter_text(levels.fall_rad_s, "rad/s");
  figures::ReportFigure out;
  out.paper_number = 1;
  out.id = "fig-01-static-discontinuous";
  out.title = tr("Static friction, discontinuous at rest");
  out.caption =
      tr("Equation (1): break-away torque {break_away_torque}, Coulomb torque {coulomb_torque}, "
         "viscous slope {viscous_slope}, Stribeck velocity {stribeck_velocity}. The paper prints "
         "no values; these parameters are ours, for a joint of its size.",
         {{"break_away_torque", static_torque},
          {"coulomb_torque", coulomb_torque},
          {"viscous_slope", parameter_text(levels.viscous_Nms_rad, "N·m·s/rad")},
          {"stribeck_velocity", speed}});
  out.how_to_read =
      tr("At rest the law is not a function of speed: friction equals the applied torque, whatever "
         "it is, up to ±T_brk (dotted). In motion it starts at T_brk and falls towards the Coulomb "
         "torque: at the Stribeck velocity 37 % of the excess is left. Then the viscous part takes "
         "it upwards along the dashed line. Between −T_brk and +T_brk a solver cannot determine "
         "friction from the speed, which is why figure 2 and the models with memory exist.");
  out.alt =
      tr("Friction torque against motor speed. It jumps at rest from −{break_away_torque} to "
         "+{break_away_torque}, falls on both sides within some {stribeck_velocity} towards a "
         "line that starts at {coulomb_torque} and rises with speed.",
         {{"break_away_torque", static_torque},
          {"stribeck_velocity", speed},
          {"coulomb_torque", coulomb_torque}});
  out.figure.id = out.id;
  out.figure.title = out.title;
  out.figure.panels.push_back(panel_of(friction, levels));
  return out;
}

namespace {

using wording::with_unit;

constexpr double shown_falls = 8;
constexpr double shown_thresholds = 4;

constexpr render::figure::Colour zone{230, 159, 0, 60};

StaticLevels levels_of(const friction::ThresholdSpeedFriction::Parameters& p) {
  return {p.static_Nm, p.coulomb_Nm, p.viscous_Nms_rad, 1 / p.stribeck_decay_s_rad, "1/c_{ω}", "f"};
}

std::string slope_text(double slope_Nms_rad) {
  return wording::with_unit(slope_Nms_rad, wording::prefixed("N·m·s/rad", slope_Nms_rad), 3);
}

render::figure::Panel whole(const StaticLaw& law, const StaticLevels& levels, double threshold) {
  const double largest = shown_falls * levels.fall_rad_s;
  const wording::AxisScale speeds = wording::prefixed("rad/s", largest);
  render::figure::Panel panel = static_law_panel(largest, std::max(levels.static_Nm, law(largest)));
  add_levels(panel, levels, largest);
  // The linear zone is narrower than a pixel: its ends are points of the line.
  render::figure::Series line = law_series(law, -largest, -threshold, speeds);
  const render::figure::Series forward = law_series(law, threshold, largest, speeds);
  line.x.insert(line.x.end(), forward.x.begin(), forward.x.end());
  line.y.insert(line.y.end(), forward.y.begin(), forward.y.end());
  line.label = tr("eq. (2)");
  panel.series.push_back(std::move(line));
  return panel;
}

render::figure::Panel close_up(const StaticLaw& law, double threshold) {
  using Direction = render::figure::ReferenceLine::Direction;
  const double largest = shown_thresholds * threshold;
  const double at_threshold = law(threshold);
  const wording::AxisScale speeds = wording::prefixed("rad/s", largest);
  render::figure::Panel panel = static_law_panel(largest, at_threshold);
  panel.title = tr("The linear zone");
  const double low = present(panel.y.minimum);
  const double high = present(panel.y.maximum);
  render::figure::Band band;
  band.label = tr("linear zone, slope T_{{f}}(ω_{{th}})/ω_{{th}} = {slope}",
                  {{"slope", slope_text(at_threshold / threshold)}});
  band.x = {speeds(-threshold), speeds(threshold)};
  band.low = {low, low};
  band.high = {high, high};
  band.colour = zone;
  panel.bands.push_back(std::move(band));
  const std::string text = "ω_{th} = " + parameter_text(threshold, "rad/s");
  panel.reference_lines.push_back({Direction::vertical, speeds(threshold), text});
  panel.reference_lines.push_back({Direction::vertical, speeds(-threshold), "−ω_{th}"});
  panel.series.push_back(law_series(law, -largest, largest, speeds));
  panel.series.back().label = tr("eq. (2)");
  return panel;
}

}  // namespace

figures::ReportFigure linear_zone_figure(const friction::ThresholdSpeedFriction& friction) {
  const friction::ThresholdSpeedFriction::Parameters& p = friction.parameters();
  require_positive(p.stribeck_decay_s_rad, "decay of the Stribeck effect", "s/rad");
  const StaticLevels levels = levels_of(p);
  const StaticLaw law = [&](double speed) { return friction.torque_Nm(speed); };
  const double slope = law(p.threshold_rad_s) / p.threshold_rad_s;
  constexpr double minute_s = 60;
  const double crept = p.threshold_rad_s / 2 * minute_s;
  const std::string static_torque = parameter_text(levels.static_Nm, "N·m");
  const std::string coulomb_torque = parameter_text(levels.coulomb_Nm, "N·m");
  const std::string threshold_speed = parameter_text(p.threshold_rad_s, "rad/s");
  figures::ReportFigure out;
  out.paper_number = 2;
  out.id = "fig-02-static-continuous";
  out.title = tr("Static friction with a linear zone around rest");
  out.caption =
      tr("Equation (2): break-away torque {break_away_torque}, Coulomb torque {coulomb_torque}, "
         "viscous slope {viscous_slope}, decay c_ω {decay_s_rad:.4g} s/rad; between "
         "±{threshold_speed} (threshold speed) friction is proportional to speed, {slope}. The "
         "paper prints no values except the threshold's range of 10⁻⁵ to 10⁻³ rad/s; these "
         "parameters are ours, for a joint of its size.",
         {{"break_away_torque", static_torque},
          {"coulomb_torque", coulomb_torque},
          {"viscous_slope", parameter_text(levels.viscous_Nms_rad, "N·m·s/rad")},
          {"decay_s_rad", p.stribeck_decay_s_rad},
          {"threshold_speed", threshold_speed},
          {"slope", slope_text(slope)}});
  const double enlargement =
      shown_falls * levels.fall_rad_s / (shown_thresholds * p.threshold_rad_s);
  out.how_to_read =
      tr("Above, no jump is left: the line through zero is only too steep for its slope to be "
         "seen. Away from rest friction falls exponentially with speed, so sooner but for longer "
         "than in figure 1. Below, the same enlarged {enlargement} times along the speed axis. The "
         "law never holds the shaft: a torque of half the break-away torque, at which a real joint "
         "does not move, turns the shaft at half of ω_th, {crept_angle} in a minute.",
         {{"enlargement", wording::significant(enlargement, 2)},
          {"crept_angle", wording::with_unit(crept, wording::prefixed("rad", crept), 2)}});
  out.alt =
      tr("Two charts of friction torque against motor speed. Above, it changes sign at rest, falls "
         "from {break_away_torque} to {coulomb_torque} and rises with speed. Below, near rest, it "
         "is a straight line through zero between ±{threshold_speed}, level outside.",
         {{"break_away_torque", static_torque},
          {"coulomb_torque", coulomb_torque},
          {"threshold_speed", threshold_speed}});
  out.figure.id = out.id;
  out.figure.title = out.title;
  out.figure.height_px = 1500;
  out.figure.panels = {whole(law, levels, p.threshold_rad_s), close_up(law, p.threshold_rad_s)};
  return out;
}

}  // namespace tribolog::paper::charts
