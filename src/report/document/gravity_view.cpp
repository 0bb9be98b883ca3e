// Stages 1 and 2.

#include <cmath>

#include "report/document/view_parts.h"
#include "report/elements/result_words.h"
#include "wording/rounding.h"
#include "wording/tr.h"
#include "wording/words.h"

namespace tribolog::report::document {

namespace {

using wording::tr;

std::string angle_in_words(double rad) {
  return wording::fixed(rad * wording::degree_scale().factor, 2) + "° (" + wording::fixed(rad, 4) +
         "\u00a0rad)";
}

void add_facts(const method::gravity::CogSweepResult& r, Section& section) {
  if (r.samples_used + r.samples_left_out > 0) {
    section.facts.push_back({tr("Samples used"), wording::count(r.samples_used)});
    section.facts.push_back(
        {tr("Samples left out"), tr("{samples} (rest, acceleration, reversal)",
                                    {{"samples", wording::count(r.samples_left_out)}})});
  }
  if (!r.found) return;
  section.facts.push_back(
      {tr("Angles covered"), tr("{lowest_angle} to {highest_angle}",
                                {{"lowest_angle", angle_in_words(r.lowest_rad)},
                                 {"highest_angle", angle_in_words(r.highest_rad)}})});
  section.facts.push_back({tr("Directions"), r.both_directions
                                                 ? tr("both: friction cancels in the mean")
                                                 : tr("one: friction stays in the mean torque")});
  section.facts.push_back({tr("Speed"), r.constant_speed
                                            ? tr("constant; only the plateaus are used")
                                            : tr("varying; friction and inertia are fitted too")});
  section.facts.push_back({tr("Fit"), wording::or_dash(wording::words(r.method))});
}

}  // namespace

void describe_cog_sweep(const method::gravity::CogSweepResult& r, double gear_ratio,
                        Section& section) {
  add_facts(r, section);
  if (!r.found) return;

  Table table = estimates_table(section.id + "-results",
                                tr("Results of stage {stage}", {{"stage", section.number}}));
  const statistics::Estimate argmax{r.argmax_rad, r.argmax_low_rad, r.argmax_high_rad,
                                    r.argmax_at_end ? Statement{"interval.largest_torque_at_end"}
                                                    : Statement{"interval.largest_torque"}};
  for (const wording::Scale& scale :
       {wording::degree_scale(), wording::radian_scale(r.q_peak_rad.value)}) {
    table.rows.push_back(estimate_row(tr("Angle of the largest torque"), argmax, scale));
  }
  for (const wording::Scale& scale :
       {wording::degree_scale(), wording::radian_scale(r.q_peak_rad.value)}) {
    table.rows.push_back(estimate_row(tr("q_peak, fitted"), r.q_peak_rad, scale));
    table.rows.back().is_chosen = true;
  }
  table.rows.push_back(number_row(at_motor(tr("Torque there"), gear_ratio), r.argmax_torque_Nm,
                                  wording::torque_scale(r.argmax_torque_Nm),
                                  tr("paper's method: largest torque")));
  table.rows.push_back(estimate_row(
      at_motor(gear_ratio == 1.0 ? tr("Gravity torque G") : tr("Gravity torque G/n"), gear_ratio),
      r.gravity_Nm, wording::torque_scale(r.gravity_Nm.value)));
  if (gear_ratio != 1.0) {
    const statistics::Estimate joint = statistics::scaled(r.gravity_Nm, gear_ratio);
    table.rows.push_back(estimate_row(at_joint(tr("Gravity torque G"), gear_ratio), joint,
                                      wording::torque_scale(joint.value)));
  }
  if (r.coulomb_Nm) {
    table.rows.push_back(estimate_row(at_motor(tr("Coulomb torque"), gear_ratio), *r.coulomb_Nm,
                                      wording::torque_scale(r.coulomb_Nm->value)));
  }
  if (r.viscous_Nms_rad) {
    table.rows.push_back(estimate_row(at_motor(tr("Viscous coefficient"), gear_ratio),
                                      *r.viscous_Nms_rad,
                                      wording::viscous_scale(r.viscous_Nms_rad->value)));
  }
  if (r.inertia_kgm2) {
    table.rows.push_back(estimate_row(tr("Inertia, reflected to the motor"), *r.inertia_kgm2,
                                      wording::inertia_scale(r.inertia_kgm2->value)));
  }
  const std::string fit = tr("fit of the whole sweep");
  table.rows.push_back(number_row(at_motor(tr("Torque offset that is not gravity"), gear_ratio),
                                  r.offset_Nm, wording::torque_scale(r.offset_Nm), fit));
  table.rows.push_back(number_row(tr("Residual scatter of the fit (standard deviation)"),
                                  r.residual_Nm, wording::torque_scale(r.residual_Nm), fit));
  if (r.argmax_at_end) {
    table.note =
        tr("The largest torque lies at the end of the sweep: no peak was crossed, and the paper's "
           "method gives no angle here. The fitted angle is an extrapolation.");
  } else {
    table.note =
        tr("Near the peak the torque is flat: 1° away it is 0.015 % lower. The interval of the "
           "largest torque contains every angle that noise cannot distinguish from it.");
  }
  section.tables.push_back(table);
}

// Stage 4.

void describe_surrogate_masses(const calibration::Calibration& c, Section& section) {
  if (c.masses.masses.empty()) return;
  section.facts.push_back(
      {tr("Surrogate distance r"),
       tr("{distance}, freely chosen",
          {{"distance",
            wording::with_unit(wording::as_stated(c.manifest.surrogate_distance_m), "m")}})});
  section.facts.push_back(
      {tr("Gravity g"), wording::with_unit(wording::as_stated(c.manifest.gravity_m_s2), "m/s²")});

  Table table;
  table.id = section.id + "-results";
  table.caption = tr("Surrogate mass of every estimator");
  table.columns = {{tr("Estimator"), "", false},
                   {tr("What it is"), "", false, true},
                   {at_motor(tr("Torque T"), c.manifest.drive.gear_ratio()), "N·m", true},
                   {tr("Read at q"), "°", true},
                   {tr("Surrogate mass"), "kg", true},
                   {tr("95 % interval"), "kg", true}};
  for (const method::hysteresis::SurrogateMass& m : c.masses.masses) {
    const wording::RoundedEstimate torque =
        wording::round_by_interval(m.torque_Nm, wording::plain_scale("N·m"));
    const wording::RoundedEstimate mass =
        wording::round_by_interval(m.mass_kg, wording::plain_scale("kg"));
    table.rows.push_back(
        {{elements::estimator_name(m.estimator), elements::meaning_of(m.estimator),
          torque.plus_minus(), wording::fixed(m.q_rad * wording::degree_scale().factor, 3),
          mass.plus_minus(), wording::or_dash(mass.range())},
         m.estimator == c.selection.recommended});
  }
  table.note = tr("The marked row is the one this program recommends.");
  section.tables.push_back(table);
}

}  // namespace tribolog::report::document
