// Both intervals of every quantity, and how often the paper's rule chose each point.

#include <cmath>

#include "report/view_parts.h"
#include "wording/units.h"

namespace tribolog::report {
namespace {

struct Words {
  const char* name;
  const char* quantity;
  Scale (*scale)(double);
};

Scale kilogram(double) { return plain_scale("kg"); }
Scale degree(double) { return degree_scale(); }
Scale plain(double) { return plain_scale(""); }
Scale speed(double) { return plain_scale("rad/s"); }
Scale weakening(double) { return plain_scale("N·m·s²/rad²"); }
Scale inertia(double) { return plain_scale("kg·m²"); }

const Words exact_names[] = {
    {"q_peak_rough_rad", "q_peak, rough sweep", degree},
    {"q_peak_precise_rad", "q_peak, precise sweep", degree},
    {"q_peak_rad", "q_peak, used", degree},
    {"q_c_corrected_rad", "q_c corrected, eq. (14), with the choice of the point", degree},
    {"coulomb_of_sweep_Nm", "Coulomb torque of the sweep", torque_scale},
    {"lugre.bristle_stiffness_Nm_rad", "LuGre: bristle stiffness σ0", stiffness_scale},
    {"lugre.bristle_damping_Nms_rad", "LuGre: bristle damping σ1", viscous_scale},
    {"lugre.viscous_Nms_rad", "LuGre: viscous coefficient σ2", viscous_scale},
    {"lugre.static_Nm", "LuGre: static torque Ts", torque_scale},
    {"lugre.coulomb_Nm", "LuGre: Coulomb torque Tc", torque_scale},
    {"lugre.stribeck_speed_rad_s", "LuGre: Stribeck velocity ws", speed},
    {"lugre.speed_weakening_Nms2_rad2", "LuGre: fall with speed (Ts − Tc)/ws²", weakening},
    {"lugre.inertia_kgm2", "LuGre: inertia", inertia},
    {"waiboer.asperity_torque_Nm", "Eq. (6): asperity torque Ta", torque_scale},
    {"waiboer.stribeck_speed_rad_s", "Eq. (6): Stribeck velocity", speed},
    {"waiboer.stribeck_power", "Eq. (6): Stribeck power δa", plain},
    {"waiboer.viscous_coefficient", "Eq. (6): viscous coefficient cv", plain},
    {"waiboer.viscous_power", "Eq. (6): viscous power δv", plain},
    {"line.coulomb_Nm", "Straight line: Coulomb torque", torque_scale},
    {"line.viscous_Nms_rad", "Straight line: viscous coefficient", viscous_scale}};

/// The row's quantity and unit; nothing for what other rows say already (gravity says it as mass).
std::optional<std::pair<std::string, Scale>> words_for(const TwoIntervals& q, double size) {
  for (const Words& words : exact_names) {
    if (q.name == words.name) return std::pair{std::string(words.quantity), words.scale(size)};
  }
  const std::size_t dot = q.name.find('.');
  if (dot == std::string::npos) return std::nullopt;
  const std::string estimator = estimator_name(q.name.substr(dot + 1));
  if (q.name.starts_with("mass_kg.")) {
    return std::pair{"Surrogate mass, " + estimator, kilogram(size)};
  }
  if (q.name.starts_with("quality_error_percent.")) {
    return std::pair{"Quality error (rms), " + estimator, plain_scale("% of T")};
  }
  return std::nullopt;
}

std::string range(const std::optional<Estimate>& estimate, const Scale& scale) {
  return estimate ? or_dash(round_by_interval(*estimate, scale).range()) : "–";
}

Table intervals_table(const IntervalsResult& intervals) {
  Table table;
  table.id = "table-intervals";
  table.caption = "95 % intervals by closed form and by bootstrap";
  table.columns = {{"Quantity", "", false, true}, {"Estimate", "", true},
                   {"Unit", "", false},           {"Closed form", "", true},
                   {"Bootstrap", "", true},       {"Ratio of widths", "", true},
                   {"Stated", "", false}};
  for (const TwoIntervals& q : intervals.quantities) {
    const Estimate* stated = q.stated();
    if (stated == nullptr || !std::isfinite(stated->value)) continue;
    const auto words = words_for(q, stated->value);
    if (!words) continue;
    const auto& [quantity, scale] = *words;
    const double ratio = q.ratio();
    const bool by_bootstrap = q.bootstrap && stated == &*q.bootstrap;
    table.rows.push_back(
        {{quantity, round_by_interval(*stated, scale).estimate, or_dash(scale.unit),
          range(q.closed_form, scale), range(q.bootstrap, scale), ratio > 0 ? fixed(ratio, 2) : "–",
          by_bootstrap ? "bootstrap" : "closed form"},
         false});
  }
  table.note =
      "Torques, stiffnesses and coefficients are at the motor. The interval stated is the closed "
      "form wherever it was found to cover as often as it says, the bootstrap elsewhere. Both "
      "need at least a handful of blocks; neither knows of an error that is the same in all of "
      "them.";
  return table;
}

Table choices_table(const std::vector<ChoiceShare>& choices) {
  Table table;
  table.id = "table-choices";
  table.caption = "How often the paper's rule chose each point";
  table.columns = {{"Point", "", false}, {"Share of the resamples", "%", true}};
  for (const ChoiceShare& choice : choices) {
    table.rows.push_back({{choice.estimator, fixed(100 * choice.share, 1)}, false});
  }
  return table;
}

}  // namespace

void add_interval_tables(const Calibration& c, Section& section) {
  const IntervalsResult& intervals = c.intervals;
  section.facts.push_back(
      {"Resamples", intervals.resamples == 0
                        ? std::string("none: intervals by closed forms alone")
                        : count(intervals.resamples) + ", seed " + std::to_string(intervals.seed)});
  section.tables.push_back(intervals_table(intervals));
  if (!intervals.choices.empty()) section.tables.push_back(choices_table(intervals.choices));
}

}  // namespace tribolog::report
