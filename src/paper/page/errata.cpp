#include <algorithm>
#include <cmath>

#include "friction/catalogue.h"
#include "friction/static_laws.h"
#include "joint/degrees.h"
#include "joint/gravity_load.h"
#include "method/hysteresis/estimator.h"
#include "method/selection/friction_parameters.h"
#include "paper/charts/paper_charts.h"
#include "paper/drawings/printed_paper.h"
#include "paper/page/page_parts.h"
#include "report/elements/elements.h"
#include "report/engine/template_engine.h"
#include "wording/axis_scale.h"
#include "wording/number_text.h"
#include "wording/rounding.h"
#include "wording/tr.h"

namespace tribolog::paper::page {
namespace {

namespace printed = drawings;
using wording::tr;

std::string cut(double value, int decimals) {
  const double unit = std::pow(10.0, decimals);
  return wording::fixed(std::trunc(value * unit) / unit, decimals);
}

const printed::TorqueRow& row(char point) {
  return *std::find_if(printed::table_2.begin(), printed::table_2.end(),
                       [point](const printed::TorqueRow& r) { return r.point == point; });
}

double pair_mass_kg(char one, char other) {
  return printed::mass_of_torque_kg((row(one).torque_Nm + row(other).torque_Nm) / 2);
}

void add_equation_12(ErrataNumbers& e) {
  const printed::TorqueRow& a = row('A');
  const double mass_A = printed::mass_of_torque_kg(a.torque_Nm);
  const double n = printed::gear_ratio;
  e.torque_A = wording::fixed(a.torque_Nm, 3);
  e.mass_A_printed = wording::fixed(a.mass_kg, 3);
  e.mass_A_with_500_mm = wording::fixed(mass_A, 3);
  e.mass_A_with_500_m =
      wording::fixed(joint::surrogate_mass_kg(a.torque_Nm, n, printed::distance_printed_m,
                                              printed::gravity_m_s2, 1.0),
                     3);
  e.mass_A_with_n_below = wording::fixed(mass_A / (n * n), 4);
  e.mass_A_arm_torque_with_n_below = wording::fixed(mass_A / n, 3);
  const double cosine = std::cos(printed::precise_angle_deg * joint::rad_per_degree);
  e.cos_q_c = wording::fixed(cosine, 4);
  e.mass_A_with_cos_q_c = wording::fixed(mass_A / cosine, 2);
}

void add_table_2(ErrataNumbers& e) {
  double largest = 0.0;
  double lightest = printed::table_2.front().mass_kg;
  double heaviest = lightest;
  for (const printed::TorqueRow& r : printed::table_2) {
    largest = std::max(largest, std::abs(printed::mass_of_torque_kg(r.torque_Nm) - r.mass_kg));
    lightest = std::min(lightest, r.mass_kg);
    heaviest = std::max(heaviest, r.mass_kg);
  }
  e.largest_deviation = wording::fixed(largest, 4);
  e.allowed_deviation = wording::fixed(printed::rounding_kg(), 4);
  const double ab = pair_mass_kg('A', 'B');
  const double cd = pair_mass_kg('C', 'D');
  const double ef = pair_mass_kg('E', 'F');
  e.pair_masses = tr("{mass_ab}, {mass_cd} and {mass_ef}", {{"mass_ab", wording::fixed(ab, 2)},
                                                            {"mass_cd", wording::fixed(cd, 2)},
                                                            {"mass_ef", wording::fixed(ef, 2)}});
  e.pair_spread = wording::fixed(std::max({ab, cd, ef}) - std::min({ab, cd, ef}), 2);
  e.single_spread = wording::fixed(heaviest - lightest, 2);
}

void add_angles(ErrataNumbers& e) {
  const double rough = printed::rough_angle_deg * joint::rad_per_degree;
  const double precise = printed::precise_angle_deg * joint::rad_per_degree;
  e.rad_of_22 = wording::fixed(rough, 5);
  e.rad_of_precise = wording::fixed(precise, 6);
  const auto how = [](bool is_cut) { return is_cut ? tr("cut") : tr("misprinted"); };
  e.cut_of_22 = how(cut(rough, 3) == wording::fixed(printed::rough_angle_rad, 3));
  e.cut_of_precise = how(cut(precise, 5) == wording::fixed(printed::precise_angle_rad, 5));
}

/// The bristle deflection at which the static force of table 1 is reached is F_s / s0.
void add_table_1(ErrataNumbers& e) {
  const friction::ContactParameters meant;
  constexpr double to_km = 1e-3;
  constexpr double to_um = 1e6;
  e.table_1_deflection_printed = wording::with_unit(
      wording::significant(meant.static_Nm / printed::table_1_stiffness_N_m * to_km, 3), "km");
  e.table_1_deflection_meant = wording::with_unit(
      wording::significant(meant.static_Nm / meant.stiffness_Nm_rad * to_um, 3), "µm");
  e.table_1_damping = wording::with_unit(wording::significant(meant.damping_Nms_rad, 4), "N·s/m");
}

/// Eq. (1) and (2) with the numbers of table 1, moving backwards.
void add_static_laws(ErrataNumbers& e) {
  const friction::ContactParameters c;
  const friction::StribeckFriction law(
      {{c.coulomb_Nm, c.static_Nm, c.stribeck_speed_rad_s, 2.0}, c.viscous_Nms_rad});
  const double backwards = -c.stribeck_speed_rad_s;
  const double meant = law.torque_Nm(backwards);
  e.backwards_speed = wording::with_unit(wording::significant(backwards, 1), "m/s");
  e.equation_1_meant = wording::with_unit(wording::significant(meant, 4), "N");
  e.equation_1_printed = wording::with_unit(
      std::string("+").append(wording::significant(law.torque_Nm(-backwards), 4)), "N");
  const double threshold = printed::largest_threshold_rad_s * c.stribeck_speed_rad_s;
  const friction::ThresholdSpeedFriction continuous(
      {c.coulomb_Nm, c.static_Nm, 1 / c.stribeck_speed_rad_s, c.viscous_Nms_rad, threshold});
  const double jump =
      continuous.torque_Nm(threshold) - continuous.torque_Nm(std::nextafter(threshold, 0.0));
  e.equation_2_jump = wording::with_unit(wording::significant(std::abs(jump), 2), "N");
  e.equation_2_half =
      wording::fixed(continuous.torque_Nm(threshold / 2) / continuous.torque_Nm(threshold), 3);
}

/// The linear branch of eq. (2) with the sign and the exponential of |ω| that print leaves in it,
/// at half of the threshold, moving backwards; and as meant, a straight line between its ends.
void add_linear_branch(ErrataNumbers& e) {
  const friction::ThresholdSpeedFriction law = charts::linear_zone_at_joint_scale();
  const friction::ThresholdSpeedFriction::Parameters& p = law.parameters();
  const double speed = -p.threshold_rad_s / 2;
  const double level = p.coulomb_Nm + (p.static_Nm - p.coulomb_Nm) *
                                          std::exp(-p.stribeck_decay_s_rad * std::abs(speed));
  const double sign = speed < 0 ? -1 : 1;
  const double as_printed =
      speed * (p.viscous_Nms_rad * p.threshold_rad_s + level * sign) / p.threshold_rad_s;
  e.linear_branch_speed = wording::with_unit(wording::significant(speed * 1e3, 2), "mrad/s");
  e.linear_branch_printed = wording::with_unit(
      std::string(as_printed > 0 ? "+" : "").append(wording::fixed(as_printed, 3)), "N·m");
  e.linear_branch_meant = wording::with_unit(wording::fixed(law.torque_Nm(speed), 3), "N·m");
}

/// Eq. (12) of the same weight where the torque counts the other way round.
void add_bars(ErrataNumbers& e) {
  const double mirrored = printed::mass_of_torque_kg(-row('B').torque_Nm);
  e.mass_B_mirrored = wording::fixed(mirrored, 3);
  e.mass_B_mirrored_in_bars = wording::fixed(std::abs(mirrored), 3);
}

/// Figure 5: what a force and what a friction of its first amplitude does.
void add_figure_5(const charts::PreslidingLoops& loops, ErrataNumbers& e) {
  const auto length = [](double length_m) {
    return wording::with_unit(length_m, wording::prefixed("m", length_m), 4);
  };
  const simulate::PreslidingLoop& forced = loops.by_force.at(0);
  e.figure_5_travel = length(loops.by_friction.at(0).travel_m);
  e.figure_5_forced_width = length(forced.width_m);
  e.figure_5_forced_speed =
      wording::significant(forced.largest_speed_m_s / forced.stribeck_speed_m_s, 2);
}

/// Eq. (6) as printed, with the angle where its rate belongs, and eq. (10) without q_c.
void add_angles_in_laws(ErrataNumbers& e) {
  constexpr double lowest_deg = -80;
  constexpr double stribeck_power = 0.7;
  const double printed_term = std::pow(lowest_deg * joint::rad_per_degree, stribeck_power);
  e.equation_6_printed =
      std::isnan(printed_term) ? tr("no real number") : wording::significant(printed_term, 3);
  constexpr double gravity_Nm = 3.88318571;  // at the motor, of the joint that gives table 2
  const double lost =
      gravity_Nm * (1 - std::cos(printed::precise_angle_deg * joint::rad_per_degree));
  e.equation_10_gravity = wording::with_unit(wording::fixed(gravity_Nm, 3), "N·m");
  e.equation_10_error = wording::with_unit(wording::fixed(lost, 3), "N·m");
}

}  // namespace

ErrataNumbers errata_numbers(const charts::PreslidingLoops& loops) {
  ErrataNumbers e;
  add_equation_12(e);
  add_table_2(e);
  add_angles(e);
  add_table_1(e);
  add_static_laws(e);
  add_angles_in_laws(e);
  add_linear_branch(e);
  add_bars(e);
  add_figure_5(loops, e);
  return e;
}

void fill_errata(const charts::PreslidingLoops& loops, report::engine::TemplateValues& values) {
  const ErrataNumbers e = errata_numbers(loops);
  report::engine::TemplateValues& out = values.add_include("ERRATA", "errata.tpl");
  out.set("LINEAR_BRANCH_SPEED", e.linear_branch_speed);
  out.set("LINEAR_BRANCH_PRINTED", e.linear_branch_printed);
  out.set("LINEAR_BRANCH_MEANT", e.linear_branch_meant);
  out.set("MASS_B_MIRRORED", e.mass_B_mirrored);
  out.set("MASS_B_IN_BARS", e.mass_B_mirrored_in_bars);
  out.set("FIGURE_5_TRAVEL", e.figure_5_travel);
  out.set("FIGURE_5_FORCED_WIDTH", e.figure_5_forced_width);
  out.set("FIGURE_5_FORCED_SPEED", e.figure_5_forced_speed);
  out.set("TORQUE_A", e.torque_A);
  out.set("MASS_A_PRINTED", e.mass_A_printed);
  out.set("MASS_A_500_MM", e.mass_A_with_500_mm);
  out.set("MASS_A_500_M", e.mass_A_with_500_m);
  out.set("MASS_A_N_BELOW", e.mass_A_with_n_below);
  out.set("MASS_A_ARM_N_BELOW", e.mass_A_arm_torque_with_n_below);
  out.set("LARGEST_DEVIATION", e.largest_deviation);
  out.set("ALLOWED_DEVIATION", e.allowed_deviation);
  out.set("COS_Q_C", e.cos_q_c);
  out.set("MASS_A_COS_Q_C", e.mass_A_with_cos_q_c);
  out.set("RAD_OF_22", e.rad_of_22);
  out.set("RAD_OF_PRECISE", e.rad_of_precise);
  out.set("CUT_OF_22", e.cut_of_22);
  out.set("CUT_OF_PRECISE", e.cut_of_precise);
  out.set("DEFLECTION_PRINTED", e.table_1_deflection_printed);
  out.set("DEFLECTION_MEANT", e.table_1_deflection_meant);
  out.set("DAMPING_MEANT", e.table_1_damping);
  out.set("BACKWARDS_SPEED", e.backwards_speed);
  out.set("EQUATION_1_MEANT", e.equation_1_meant);
  out.set("EQUATION_1_PRINTED", e.equation_1_printed);
  out.set("EQUATION_2_JUMP", e.equation_2_jump);
  out.set("EQUATION_2_HALF", e.equation_2_half);
  out.set("EQUATION_6_PRINTED", e.equation_6_printed);
  out.set("EQUATION_10_GRAVITY", e.equation_10_gravity);
  out.set("EQUATION_10_ERROR", e.equation_10_error);
  out.set("PAIR_MASSES", e.pair_masses);
  out.set("PAIR_SPREAD", e.pair_spread);
  out.set("SINGLE_SPREAD", e.single_spread);
}

/// The runs of rising angle alone, as print shows one direction: with both, an error of the mass
/// would cancel.
method::viscous::ViscousCurvesResult rising_runs(method::viscous::ViscousCurvesResult curves) {
  const std::vector<method::viscous::ConstantSpeedRun> runs = curves.runs;
  const auto is_falling = [&](std::size_t i) { return runs[i].speed_rad_s < 0; };
  for (method::viscous::ViscousCurve& curve : curves.curves) {
    std::size_t i = 0;
    std::erase_if(curve.friction_Nm, [&](double) { return is_falling(i++); });
  }
  std::erase_if(curves.runs, [](const auto& run) { return run.speed_rad_s < 0; });
  return curves;
}

report::elements::Table fits_of_equation_6(const calibration::Calibration& calibration) {
  report::elements::Table table;
  table.id = "table-equation-6";
  table.caption = tr("Eq. (6) fitted to the curve of each candidate mass, rising runs");
  const method::viscous::ViscousCurvesResult rising = rising_runs(calibration.viscous);
  table.columns = {{tr("Mass of"), "", false}, {"T_a", "N·m", true}, {"ω_s", "rad/s", true},
                   {"δ_a", "", true},          {"c_v", "N·m", true}, {"δ_v", "", true},
                   {tr("Rest"), "N·m", true}};
  const auto add = [&](method::hysteresis::Estimator estimator) {
    method::selection::SelectionResult as_if = calibration.selection;
    as_if.recommended = estimator;
    const auto fit = method::selection::fit_friction_parameters(rising, as_if).waiboer;
    const auto digits = [&](double value) { return wording::significant(value, 4); };
    const bool is_chosen = calibration.selection.paper_rule == estimator;
    const std::string name =
        estimator == method::hysteresis::Estimator::midline ? tr("mid-line") : to_string(estimator);
    std::vector<std::string> cells{is_chosen ? tr("{point}, selected", {{"point", name}}) : name};
    if (fit) {
      for (const double value :
           {fit->asperity_torque_Nm.value, fit->stribeck_speed_rad_s.value,
            fit->stribeck_power.value, fit->viscous_coefficient.value, fit->viscous_power.value}) {
        cells.push_back(digits(value));
      }
      cells.push_back(wording::significant(fit->residual_Nm, 2));
    } else {
      cells.resize(table.columns.size(), "–");
    }
    table.rows.push_back({std::move(cells), false});
  };
  for (const auto point : method::hysteresis::loop_points) add(point);
  add(method::hysteresis::Estimator::midline);
  table.note =
      tr("Rest: standard deviation of what the five parameters leave. A mass that is wrong "
         "shifts the curve of one direction, and the fit takes the shift for friction; "
         "with the runs of both directions it cancels.");
  return table;
}

report::elements::Table table_2(const calibration::Calibration& c) {
  report::elements::Table table;
  table.id = "table-paper-2";
  table.caption = tr("Table 2 of the paper, recomputed");
  table.columns = {{tr("Point"), "", false},
                   {tr("Torque, printed"), "N·m", true},
                   {tr("Mass, printed"), "kg", true},
                   {tr("Mass from the printed torque by eq. (12)"), "kg", true},
                   {tr("Recomputed − printed"), "kg", true},
                   {tr("This dataset"), "kg", true},
                   {tr("This dataset against printed"), "%", true}};
  constexpr int decimals = 3;
  for (const printed::TorqueRow& row : printed::table_2) {
    const double mass = printed::mass_of_torque_kg(row.torque_Nm);
    const std::string name(1, row.point);
    report::elements::Row cells{
        {name, wording::fixed(row.torque_Nm, decimals), wording::fixed(row.mass_kg, decimals),
         wording::fixed(mass, decimals), wording::fixed(mass - row.mass_kg, decimals), "–", "–"},
        false};
    if (const method::hysteresis::SurrogateMass* ours =
            c.masses.find(method::hysteresis::estimator_of(name))) {
      cells.cells[5] =
          wording::round_by_interval(ours->mass_kg, wording::plain_scale("kg")).plus_minus();
      const double more = ours->mass_kg.value / row.mass_kg - 1.0;
      cells.cells[6] = wording::with_plus_sign(wording::fixed(100.0 * more, 2));
    }
    table.rows.push_back(std::move(cells));
  }
  table.note =
      tr("Printed columns: joint 3 of a FANUC AM100iB, n = 100, r = 0.5 m. Rounding of the "
         "printed figures alone allows {mass_kg} kg of difference.",
         {{"mass_kg", wording::fixed(printed::rounding_kg(), 4)}});
  return table;
}

}  // namespace tribolog::paper::page
