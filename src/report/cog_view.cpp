// Stages 1 and 2.

#include <cmath>

#include "report/view_parts.h"
#include "wording/units.h"

namespace tribolog::report {
namespace {

std::string angle_in_words(double rad) {
  return fixed(rad * degree_scale().factor, 2) + "° (" + fixed(rad, 4) + "\u00a0rad)";
}

void add_facts(const CogSweepResult& r, Section& section) {
  if (r.samples_used + r.samples_left_out > 0) {
    section.facts.push_back({"Samples used", count(r.samples_used)});
    section.facts.push_back(
        {"Samples left out", count(r.samples_left_out) + " (rest, acceleration, reversal)"});
  }
  if (!r.found) return;
  section.facts.push_back(
      {"Angles covered", angle_in_words(r.lowest_rad) + " to " + angle_in_words(r.highest_rad)});
  section.facts.push_back({"Directions", r.both_directions
                                             ? "both: friction cancels in the mean"
                                             : "one: friction stays in the mean torque"});
  section.facts.push_back({"Speed", r.constant_speed
                                        ? "constant, only the plateaus are used"
                                        : "varying, friction and inertia are fitted along"});
  section.facts.push_back({"Fit", or_dash(r.method)});
}

}  // namespace

void describe_cog_sweep(const CogSweepResult& r, double gear_ratio, Section& section) {
  add_facts(r, section);
  if (!r.found) return;

  Table table;
  table.id = section.id + "-results";
  table.caption = "Results of stage " + std::to_string(section.number);
  table.columns = estimate_columns();
  const Estimate argmax{r.argmax_rad, r.argmax_low_rad, r.argmax_high_rad,
                        r.argmax_at_end ? "paper's way; lies at the end of the sweep"
                                        : "paper's way: largest torque"};
  for (const Scale& scale : {degree_scale(), radian_scale(r.q_peak_rad.value)}) {
    table.rows.push_back(estimate_row("Angle of the largest torque", argmax, scale));
  }
  for (const Scale& scale : {degree_scale(), radian_scale(r.q_peak_rad.value)}) {
    table.rows.push_back(estimate_row("q_peak, fitted", r.q_peak_rad, scale));
    table.rows.back().is_chosen = true;
  }
  table.rows.push_back(number_row("Torque there, at the motor", r.argmax_torque_Nm,
                                  torque_scale(r.argmax_torque_Nm), "paper's way: largest torque"));
  table.rows.push_back(estimate_row("Gravity torque G/n, at the motor", r.gravity_Nm,
                                    torque_scale(r.gravity_Nm.value)));
  if (gear_ratio != 1.0) {
    const Estimate joint = scaled(r.gravity_Nm, gear_ratio);
    table.rows.push_back(
        estimate_row("Gravity torque G, at the joint", joint, torque_scale(joint.value)));
  }
  if (r.coulomb_Nm) {
    table.rows.push_back(estimate_row("Coulomb torque, at the motor", *r.coulomb_Nm,
                                      torque_scale(r.coulomb_Nm->value)));
  }
  if (r.viscous_Nms_rad) {
    table.rows.push_back(estimate_row("Viscous coefficient, at the motor", *r.viscous_Nms_rad,
                                      viscous_scale(r.viscous_Nms_rad->value)));
  }
  if (r.inertia_kgm2) {
    table.rows.push_back(
        estimate_row("Inertia, reflected to the motor", *r.inertia_kgm2, plain_scale("kg·m²")));
  }
  const std::string fit = "fit of the whole sweep";
  table.rows.push_back(number_row("Torque offset that is not gravity, at the motor", r.offset_Nm,
                                  torque_scale(r.offset_Nm), fit));
  table.rows.push_back(number_row("Scatter left by the fit (standard deviation)", r.residual_Nm,
                                  torque_scale(r.residual_Nm), fit));
  if (r.argmax_at_end) {
    table.note =
        "The largest torque lies at the end of the sweep: no peak was crossed, and the "
        "paper's way gives no angle here. The fitted angle is an extrapolation.";
  } else {
    table.note =
        "Near the peak the torque is flat: 1° off costs 0.015 % of it. The interval of the "
        "largest torque holds every angle that noise cannot tell from it.";
  }
  section.tables.push_back(table);
}

}  // namespace tribolog::report
