#include "paper/charts/linear_zone_figure.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "base/parameter_rules.h"
#include "base/present.h"
#include "figures/plot_data.h"
#include "paper/charts/static_law_panel.h"
#include "wording/number_text.h"

namespace tribolog::paper {
namespace {

using figures::AxisScale;
using figures::prefixed;
using figures::with_unit;

constexpr double shown_falls = 8;
constexpr double shown_thresholds = 4;

constexpr render::Colour zone{230, 159, 0, 60};

StaticLevels levels_of(const ThresholdSpeedFriction::Parameters& p) {
  return {p.static_Nm, p.coulomb_Nm, p.viscous_Nms_rad, 1 / p.stribeck_decay_s_rad, "1/c_{ω}", "f"};
}

std::string slope_text(double slope_Nms_rad) {
  return with_unit(slope_Nms_rad, prefixed("N·m·s/rad", slope_Nms_rad), 3);
}

render::Panel whole(const StaticLaw& law, const StaticLevels& levels, double threshold) {
  const double largest = shown_falls * levels.fall_rad_s;
  const AxisScale speeds = prefixed("rad/s", largest);
  render::Panel panel = static_law_panel(largest, std::max(levels.static_Nm, law(largest)));
  add_levels(panel, levels, largest);
  // The linear zone is narrower than a pixel: its ends are points of the line.
  render::Series line = law_series(law, -largest, -threshold, speeds);
  const render::Series forward = law_series(law, threshold, largest, speeds);
  line.x.insert(line.x.end(), forward.x.begin(), forward.x.end());
  line.y.insert(line.y.end(), forward.y.begin(), forward.y.end());
  line.label = "eq. (2)";
  panel.series.push_back(std::move(line));
  return panel;
}

render::Panel close_up(const StaticLaw& law, double threshold) {
  using Direction = render::ReferenceLine::Direction;
  const double largest = shown_thresholds * threshold;
  const double at_threshold = law(threshold);
  const AxisScale speeds = prefixed("rad/s", largest);
  render::Panel panel = static_law_panel(largest, at_threshold);
  panel.title = "The linear zone";
  const double low = present(panel.y.minimum);
  const double high = present(panel.y.maximum);
  render::Band band;
  band.label = fmt::format("linear zone, slope T_{{f}}(ω_{{th}})/ω_{{th}} = {}",
                           slope_text(at_threshold / threshold));
  band.x = {speeds(-threshold), speeds(threshold)};
  band.low = {low, low};
  band.high = {high, high};
  band.colour = zone;
  panel.bands.push_back(std::move(band));
  const std::string text = "ω_{th} = " + parameter_text(threshold, "rad/s");
  panel.reference_lines.push_back({Direction::vertical, speeds(threshold), text});
  panel.reference_lines.push_back({Direction::vertical, speeds(-threshold), "−ω_{th}"});
  panel.series.push_back(law_series(law, -largest, largest, speeds));
  panel.series.back().label = "eq. (2)";
  return panel;
}

}  // namespace

ReportFigure linear_zone_figure(const ThresholdSpeedFriction& friction) {
  const ThresholdSpeedFriction::Parameters& p = friction.parameters();
  require_positive(p.stribeck_decay_s_rad, "decay of the Stribeck effect", "s/rad");
  const StaticLevels levels = levels_of(p);
  const StaticLaw law = [&](double speed) { return friction.torque_Nm(speed); };
  const double slope = law(p.threshold_rad_s) / p.threshold_rad_s;
  constexpr double minute_s = 60;
  const double crept = p.threshold_rad_s / 2 * minute_s;
  ReportFigure out;
  out.number = 2;
  out.id = "fig-02-static-continuous";
  out.title = "Static friction with a linear zone around rest";
  out.caption = fmt::format(
      "Equation (2): {}, decay c_ω {:.4g} s/rad; between ±{} (threshold speed) friction is "
      "proportional to speed, {}. The paper prints no values except the threshold's range of "
      "10⁻⁵ to 10⁻³ rad/s; these parameters are ours, at the size of its joint.",
      levels_words(levels), p.stribeck_decay_s_rad, parameter_text(p.threshold_rad_s, "rad/s"),
      slope_text(slope));
  out.how_to_read = fmt::format(
      "Above, no jump is left: the line through zero is only too steep to see that it leans. Away "
      "from rest friction falls exponentially with speed, so sooner but longer than in figure 1. "
      "Below, the same enlarged {} times along the speed. The law never holds: a torque of half "
      "the "
      "break-away torque, at which a real joint stands still, turns the shaft at half of ω_th, {} "
      "in a "
      "minute.",
      figures::significant(shown_falls * levels.fall_rad_s / (shown_thresholds * p.threshold_rad_s),
                           2),
      with_unit(crept, prefixed("rad", crept), 2));
  out.alt = fmt::format(
      "Two charts of friction torque against motor speed. Above it changes sides at rest, falls "
      "from {} to {} and rises with speed. Below, near rest, it is a straight line through zero "
      "between ±{}, level outside.",
      parameter_text(levels.static_Nm, "N·m"), parameter_text(levels.coulomb_Nm, "N·m"),
      parameter_text(p.threshold_rad_s, "rad/s"));
  out.figure.id = out.id;
  out.figure.title = out.title;
  out.figure.height_px = 1500;
  out.figure.panels = {whole(law, levels, p.threshold_rad_s), close_up(law, p.threshold_rad_s)};
  return out;
}

}  // namespace tribolog::paper
