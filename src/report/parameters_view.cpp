// Stage 8.

#include "report/view_parts.h"
#include "wording/units.h"

namespace tribolog::report {
namespace {

Table estimates(const std::string& id, const std::string& caption) {
  Table table;
  table.id = id;
  table.caption = caption;
  table.columns = estimate_columns();
  return table;
}

void add_both_sides(const std::string& quantity, const Estimate& motor, double n, double to_joint,
                    Scale (*scale_for)(double), Table& table) {
  const std::string at_motor = n == 1.0 ? "" : ", at the motor";
  table.rows.push_back(estimate_row(quantity + at_motor, motor, scale_for(motor.value)));
  if (n == 1.0) return;
  const Estimate joint = scaled(motor, to_joint);
  table.rows.push_back(estimate_row(quantity + ", at the joint", joint, scale_for(joint.value)));
}

Table line_table(const CoulombViscousFit& f, double n, const Section& section) {
  Table table =
      estimates(section.id + "-line", "Coulomb and viscous friction: |T_f| = T_c + c |ω|");
  add_both_sides("Coulomb torque T_c", f.coulomb_Nm, n, n, torque_scale, table);
  add_both_sides("Viscous coefficient c", f.viscous_Nms_rad, n, n * n, viscous_scale, table);
  table.rows.push_back(number_row("Scatter left by the fit (standard deviation)", f.residual_Nm,
                                  torque_scale(f.residual_Nm), "fit"));
  constexpr int digits = 3;
  table.note = "Fitted to motor speeds from " + significant(f.slowest_rad_s, digits) + " to " +
               with_unit(significant(f.fastest_rad_s, digits), "rad/s") +
               ", beyond the Stribeck dip; not to be used below.";
  return table;
}

Table waiboer_table(const WaiboerFit& f, const Section& section) {
  Table table = estimates(section.id + "-waiboer",
                          "Friction of a geared joint after Waiboer et al., eq. (6), at the motor");
  table.rows = {estimate_row("Asperity torque T_a", f.asperity_torque_Nm,
                             torque_scale(f.asperity_torque_Nm.value)),
                estimate_row("Stribeck velocity ω_s", f.stribeck_speed_rad_s, plain_scale("rad/s")),
                estimate_row("Stribeck power δ_a", f.stribeck_power, plain_scale("")),
                estimate_row("Viscous coefficient c_v", f.viscous_coefficient,
                             plain_scale("N·m·(s/rad)^(1−δ_v)")),
                estimate_row("Viscous power δ_v", f.viscous_power, plain_scale("")),
                number_row("Scatter left by the fit (standard deviation)", f.residual_Nm,
                           torque_scale(f.residual_Nm), "fit")};
  if (!f.converged)
    table.note = "The fit did not converge: these are its last values, not results.";
  return table;
}

}  // namespace

void describe_parameters(const Calibration& c, Section& section) {
  const double n = c.manifest.drive.gear_ratio();
  const FrictionParametersResult& f = c.friction;
  if (!f.curve.empty()) {
    section.facts.push_back({"Curve fitted", f.curve == "direction_difference"
                                                 ? "half the difference of the two directions"
                                                 : "that of " + estimator_name(f.curve)});
  }
  describe_curve_models(c, section);
  if (f.waiboer) section.tables.push_back(waiboer_table(*f.waiboer, section));
  if (f.coulomb_viscous) section.tables.push_back(line_table(*f.coulomb_viscous, n, section));
  if (c.hysteresis.lugre) describe_lugre(*c.hysteresis.lugre, n, section);
}

}  // namespace tribolog::report
