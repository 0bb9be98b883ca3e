// Stages 1 and 2.

#include <cmath>

#include "paper/drawings/printed_paper.h"
#include "report/estimator_words.h"
#include "report/view_parts.h"
#include "wording/units.h"
#include "wording/words.h"

namespace tribolog::report {

namespace {

std::string angle_in_words(double rad) {
  return wording::fixed(rad * wording::degree_scale().factor, 2) + "° (" + wording::fixed(rad, 4) +
         "\u00a0rad)";
}

void add_facts(const method::gravity::CogSweepResult& r, Section& section) {
  if (r.samples_used + r.samples_left_out > 0) {
    section.facts.push_back({"Samples used", wording::count(r.samples_used)});
    section.facts.push_back({"Samples left out", wording::count(r.samples_left_out) +
                                                     " (rest, acceleration, reversal)"});
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
  section.facts.push_back({"Fit", or_dash(wording::words(r.method))});
}

}  // namespace

void describe_cog_sweep(const method::gravity::CogSweepResult& r, double gear_ratio,
                        Section& section) {
  add_facts(r, section);
  if (!r.found) return;

  Table table;
  table.id = section.id + "-results";
  table.caption = "Results of stage " + std::to_string(section.number);
  table.columns = estimate_columns();
  const statistics::Estimate argmax{r.argmax_rad, r.argmax_low_rad, r.argmax_high_rad,
                                    r.argmax_at_end ? Statement{"interval.largest_torque_at_end"}
                                                    : Statement{"interval.largest_torque"}};
  for (const wording::Scale& scale :
       {wording::degree_scale(), wording::radian_scale(r.q_peak_rad.value)}) {
    table.rows.push_back(estimate_row("Angle of the largest torque", argmax, scale));
  }
  for (const wording::Scale& scale :
       {wording::degree_scale(), wording::radian_scale(r.q_peak_rad.value)}) {
    table.rows.push_back(estimate_row("q_peak, fitted", r.q_peak_rad, scale));
    table.rows.back().is_chosen = true;
  }
  table.rows.push_back(number_row("Torque there, at the motor", r.argmax_torque_Nm,
                                  wording::torque_scale(r.argmax_torque_Nm),
                                  "paper's way: largest torque"));
  table.rows.push_back(estimate_row("Gravity torque G/n, at the motor", r.gravity_Nm,
                                    wording::torque_scale(r.gravity_Nm.value)));
  if (gear_ratio != 1.0) {
    const statistics::Estimate joint = statistics::scaled(r.gravity_Nm, gear_ratio);
    table.rows.push_back(
        estimate_row("Gravity torque G, at the joint", joint, wording::torque_scale(joint.value)));
  }
  if (r.coulomb_Nm) {
    table.rows.push_back(estimate_row("Coulomb torque, at the motor", *r.coulomb_Nm,
                                      wording::torque_scale(r.coulomb_Nm->value)));
  }
  if (r.viscous_Nms_rad) {
    table.rows.push_back(estimate_row("Viscous coefficient, at the motor", *r.viscous_Nms_rad,
                                      wording::viscous_scale(r.viscous_Nms_rad->value)));
  }
  if (r.inertia_kgm2) {
    table.rows.push_back(estimate_row("Inertia, reflected to the motor", *r.inertia_kgm2,
                                      wording::plain_scale("kg·m²")));
  }
  const std::string fit = "fit of the whole sweep";
  table.rows.push_back(number_row("Torque offset that is not gravity, at the motor", r.offset_Nm,
                                  wording::torque_scale(r.offset_Nm), fit));
  table.rows.push_back(number_row("Scatter left by the fit (standard deviation)", r.residual_Nm,
                                  wording::torque_scale(r.residual_Nm), fit));
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

// Stage 4, and the comparison with the paper's table 2.

namespace {

bool is_chosen(const calibration::Calibration& c, const std::string& estimator) {
  return estimator == c.selection.recommended;
}

/// Deviation in per cent with its sign: "+0.12".
std::string percent_text(double share) {
  constexpr int decimals = 2;
  return wording::with_plus_sign(wording::fixed(100.0 * share, decimals));
}

}  // namespace

void describe_surrogate_masses(const calibration::Calibration& c, Section& section) {
  if (c.masses.masses.empty()) return;
  section.facts.push_back(
      {"Surrogate distance r",
       wording::with_unit(wording::as_stated(c.manifest.surrogate_distance_m), "m") +
           ", freely chosen"});
  section.facts.push_back(
      {"Gravity g", wording::with_unit(wording::as_stated(c.manifest.gravity_m_s2), "m/s²")});

  Table table;
  table.id = section.id + "-results";
  table.caption = "Surrogate mass of every estimator";
  table.columns = {{"Estimator", "", false},       {"What it is", "", false, true},
                   {"Torque T", "N·m", true},      {"Read at q", "°", true},
                   {"Surrogate mass", "kg", true}, {"95 % interval", "kg", true}};
  for (const method::hysteresis::SurrogateMass& m : c.masses.masses) {
    const wording::RoundedEstimate torque =
        wording::round_by_interval(m.torque_Nm, wording::plain_scale("N·m"));
    const wording::RoundedEstimate mass =
        wording::round_by_interval(m.mass_kg, wording::plain_scale("kg"));
    table.rows.push_back(
        {{estimator_name(m.estimator), point_meaning(m.estimator), torque.plus_minus(),
          wording::fixed(m.q_rad * wording::degree_scale().factor, 3), mass.plus_minus(),
          or_dash(mass.range())},
         is_chosen(c, m.estimator)});
  }
  table.note = "Torques are at the motor. The marked row is the one this program recommends.";
  section.tables.push_back(table);
  if (is_papers_joint(c.manifest.robot, c.manifest.drive.gear_ratio())) {
    section.tables.push_back(paper_comparison_table(c));
  }
}

Table paper_comparison_table(const calibration::Calibration& c) {
  const bool is_same_joint = is_papers_joint(c.manifest.robot, c.manifest.drive.gear_ratio());
  Table table;
  table.id = "table-paper-2";
  table.caption = "Table 2 of the paper, recomputed";
  table.columns = {{"Point", "", false},
                   {"Torque, printed", "N·m", true},
                   {"Mass, printed", "kg", true},
                   {"Mass from the printed torque by eq. (12)", "kg", true},
                   {"Recomputed less printed", "kg", true}};
  if (is_same_joint) {
    table.columns.push_back({"This dataset", "kg", true});
    table.columns.push_back({"This dataset against printed", "%", true});
  }
  for (const paper::drawings::TorqueRow& printed : paper::drawings::table_2) {
    constexpr int decimals = 3;
    const double mass = paper::drawings::mass_of_torque_kg(printed.torque_Nm);
    const std::string name(1, printed.point);
    Row row{{name, wording::fixed(printed.torque_Nm, decimals),
             wording::fixed(printed.mass_kg, decimals), wording::fixed(mass, decimals),
             wording::fixed(mass - printed.mass_kg, decimals)},
            false};
    if (is_same_joint) {
      const method::hysteresis::SurrogateMass* ours = c.masses.find(name);
      row.cells.push_back(
          ours ? wording::round_by_interval(ours->mass_kg, wording::plain_scale("kg")).plus_minus()
               : "–");
      row.cells.push_back(ours ? percent_text(ours->mass_kg.value / printed.mass_kg - 1.0) : "–");
    }
    table.rows.push_back(row);
  }
  table.note =
      "Printed columns: joint 3 of a FANUC AM100iB, n = 100, r = 0.5 m. Rounding of the "
      "printed figures alone allows " +
      wording::fixed(paper::drawings::rounding_kg(), 4) + " kg of difference.";
  if (!is_same_joint) {
    table.note +=
        " The joint of this report is another one: its masses are in stage 4 and are not "
        "to be compared with these.";
  }
  return table;
}

}  // namespace tribolog::report
