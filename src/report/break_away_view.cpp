// Break-away ramps: beyond the paper's eight stages.

#include <algorithm>

#include "report/view_parts.h"
#include "wording/units.h"

namespace tribolog::report {
namespace {

Table results_table(const BreakAwayResult& r, double n, const Section& section) {
  Table table;
  table.id = section.id + "-results";
  table.caption = "Break-away torque from the ramps";
  table.columns = estimate_columns();
  const auto add = [&](const std::string& quantity, const std::optional<Estimate>& motor) {
    if (!motor) return;
    table.rows.push_back(estimate_row(quantity + (n == 1.0 ? "" : ", at the motor"), *motor,
                                      torque_scale(motor->value)));
    if (n == 1.0) return;
    const Estimate joint = scaled(*motor, n);
    table.rows.push_back(
        estimate_row(quantity + ", at the joint", joint, torque_scale(joint.value)));
  };
  const std::string with_gravity = r.gravity_taken_off ? "" : " (gravity not taken off)";
  add("Towards positive torque" + with_gravity, r.rising_Nm);
  add("Towards negative torque" + with_gravity, r.falling_Nm);
  add("Mean of both directions", r.mean_Nm);
  return table;
}

std::string outcome_words(const BreakAwayRamp& ramp, const Scale& travel) {
  if (!ramp.broke_away) return "censored: did not break away";
  if (!ramp.first_slip_rad) return "broke away and slid on";
  return "broke away, stopped again after " +
         with_unit(significant(*ramp.first_slip_rad * travel.factor, 3), travel.unit);
}

Table ramps_table(const BreakAwayResult& r, const Section& section) {
  Table table;
  table.id = section.id + "-ramps";
  table.caption = "The ramps one by one";
  double furthest = 0;
  for (const BreakAwayRamp& ramp : r.ramps) furthest = std::max(furthest, ramp.travel_rad);
  const Scale travel = radian_scale(furthest);
  table.columns = {{"Recording", "", false, true},
                   {"Rate", "N·m/s", true},
                   {"Torque reached T", "N·m", true},
                   {"Friction", "N·m", true},
                   {"Pre-sliding travel", travel.unit, true},
                   {"Outcome", "", false, true}};
  for (const BreakAwayRamp& ramp : r.ramps) {
    table.rows.push_back(
        {{log_name(ramp.recording), significant(ramp.rate_Nm_s, 3), significant(ramp.torque_Nm, 4),
          (ramp.broke_away ? "" : "> ") + significant(ramp.friction_Nm, 4),
          significant(ramp.travel_rad * travel.factor, 3), outcome_words(ramp, travel)},
         false});
  }
  table.note =
      "Torques at the motor, travel of the joint. Censored: the ramp ended before the joint broke "
      "away; its friction is larger than the value, and the value takes no part in the means.";
  return table;
}

}  // namespace

void describe_break_away(const Calibration& c, Section& section) {
  const BreakAwayResult& r = c.break_away;
  if (r.ramps.empty()) return;
  section.facts.push_back({"Ramps", count(r.ramps.size())});
  section.facts.push_back({"Of these censored", count(r.censored)});
  section.facts.push_back({"Gravity", r.gravity_taken_off ? "taken off" : "not known here"});
  Table results = results_table(r, c.manifest.drive.gear_ratio(), section);
  if (!results.rows.empty()) section.tables.push_back(std::move(results));
  section.tables.push_back(ramps_table(r, section));
}

Table loop_shapes_table(const std::vector<LoopShape>& shapes, double n, const Section& section) {
  Table table;
  table.id = section.id + "-shapes";
  table.caption = "The loops as they were recorded, without any model";
  if (shapes.empty()) return table;
  const Scale angle = radian_scale(shapes.front().width_rad);
  double stiffest = 0;
  for (const LoopShape& s : shapes) {
    if (s.stiffness_Nm_rad) stiffest = std::max(stiffest, n * s.stiffness_Nm_rad->value);
  }
  const Scale stiffness = stiffness_scale(stiffest);
  table.columns = {{"Recording", "", false, true},
                   {"Width", angle.unit, true},
                   {"Height, at the motor", "N·m", true},
                   {"Closing gap", "% of the width", true},
                   {"Closed", "", false},
                   {"Work per cycle, at the joint", "mJ", true},
                   {"Stiffness after a reversal, at the joint", stiffness.unit, true},
                   {"95 % interval", stiffness.unit, true}};
  for (const LoopShape& s : shapes) {
    RoundedEstimate k;
    if (s.stiffness_Nm_rad) k = round_by_interval(scaled(*s.stiffness_Nm_rad, n), stiffness);
    table.rows.push_back(
        {{log_name(s.recording), significant(s.width_rad * angle.factor, 3),
          significant(s.height_Nm, 3), significant(100 * s.closing_gap, 2), s.closes ? "yes" : "no",
          significant(1e3 * s.dissipated_J, 3), s.stiffness_Nm_rad ? k.plus_minus() : "–",
          s.stiffness_Nm_rad ? or_dash(k.range()) : "–"},
         false});
  }
  table.note =
      "Closing gap: mean distance of the angle from where it was a cycle before; a loop is closed "
      "up to 5 %. Stiffness: slope of torque over angle in the first third of the loop's height "
      "behind a reversal; the tangent at the reversal itself is up to 1.2 times larger in a LuGre "
      "contact.";
  return table;
}

}  // namespace tribolog::report
