#pragma once
// What the charts of eq. (1) and (2) share: friction over signed speed, with its levels marked.

#include <functional>
#include <string>

#include "render/figure/figure.h"
#include "wording/axis_scale.h"

namespace tribolog::paper {

/// Friction torque [N·m] by speed [rad/s]; odd.
using StaticLaw = std::function<double(double)>;

/// Numbers by which both laws are known.
struct StaticLevels {
  double static_Nm{};
  double coulomb_Nm{};
  double viscous_Nms_rad{};
  double fall_rad_s{};       ///< Speed at which the Stribeck effect is down to 1/e of itself.
  std::string fall_symbol;   ///< With the markup of render/figure.h.
  std::string slope_symbol;  ///< Likewise.
};

/// An empty panel with its axes: speed as far as `largest_rad_s` on both sides.
render::Panel static_law_panel(double largest_rad_s, double largest_Nm);

/// The law between two speeds, as many points as a smooth line needs.
/// @param speeds the axis of the panel.
render::Series law_series(const StaticLaw& law, double from_rad_s, double to_rad_s,
                          const figures::AxisScale& speeds);

/// Adds lines at the static and Coulomb torques and at the fall of the Stribeck effect, on both
/// sides of rest, and the viscous part on top of the Coulomb torque as a dashed line.
void add_levels(render::Panel& panel, const StaticLevels& levels, double largest_rad_s);

/// A parameter as it was set: "0.884 N·m", "5 rad/s", "2.4 mN·m·s/rad". Torques keep their unit, so
/// that levels compare at a glance; others take a prefix.
std::string parameter_text(double value, const std::string& si_unit);

/// "break-away torque 0.884 N·m, Coulomb torque 0.45 N·m, ..."
std::string levels_words(const StaticLevels& levels);

}  // namespace tribolog::paper
