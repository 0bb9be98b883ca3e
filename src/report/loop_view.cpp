// Stage 8: what the hysteresis loops alone show of LuGre.

#include <algorithm>
#include <cmath>
#include <map>

#include "report/view_parts.h"
#include "wording/units.h"
#include "wording/words.h"

namespace tribolog::report {

namespace {

constexpr int few_digits = 3;

struct LuGreWords {
  const char* quantity;
  int torque_powers;  ///< Factors n from motor to joint.
  wording::Scale (*scale)(double);
};

wording::Scale weakening_scale(double) { return wording::plain_scale("N·m·s²/rad²"); }
wording::Scale speed_scale(double) { return wording::plain_scale("rad/s"); }
wording::Scale inertia_scale(double) { return wording::plain_scale("kg·m²"); }

const std::map<std::string, LuGreWords> words{
    {"bristle_stiffness_Nm_rad", {"Bristle stiffness σ₀", 2, wording::stiffness_scale}},
    {"bristle_damping_Nms_rad", {"Bristle damping σ₁", 2, wording::viscous_scale}},
    {"viscous_Nms_rad", {"Viscous coefficient σ₂", 2, wording::viscous_scale}},
    {"static_Nm", {"Break-away torque T_s", 1, wording::torque_scale}},
    {"coulomb_Nm", {"Coulomb torque T_c", 1, wording::torque_scale}},
    {"stribeck_speed_rad_s", {"Stribeck velocity ω_s", -1, speed_scale}},
    {"speed_weakening_Nms2_rad2", {"Start of the fall of friction with speed", 3, weakening_scale}},
    {"inertia_kgm2", {"Inertia J of motor, gear and arm", 2, inertia_scale}}};

void add_both_sides(const std::string& quantity, const statistics::Estimate& motor, double n,
                    int powers, wording::Scale (*scale)(double), Table& table) {
  table.rows.push_back(
      estimate_row(n == 1.0 ? quantity : quantity + ", at the motor", motor, scale(motor.value)));
  if (n == 1.0) return;
  const statistics::Estimate joint = statistics::scaled(motor, std::pow(n, powers));
  table.rows.push_back(estimate_row(quantity + ", at the joint", joint, scale(joint.value)));
}

Table shown_table(const method::hysteresis::LuGreFit& f, double n, const Section& section) {
  Table table;
  table.id = section.id + "-lugre";
  table.caption = "LuGre model, fitted to the hysteresis loops alone";
  table.columns = estimate_columns();
  for (const method::hysteresis::LuGreParameter& p : f.parameters) {
    const LuGreWords& w = words.at(p.name);
    if (p.estimate) {
      add_both_sides(w.quantity, *p.estimate, n, w.torque_powers, w.scale, table);
    } else {
      table.rows.push_back(not_identified_row(w.quantity, "not shown by this excitation"));
    }
  }
  if (f.gravity_Nm) {
    add_both_sides("Gravity torque at the peak", *f.gravity_Nm, n, 1, wording::torque_scale, table);
  }
  table.rows.push_back(number_row("Scatter left by the fit (standard deviation)", f.residual_Nm,
                                  wording::torque_scale(f.residual_Nm), "fit"));
  if (const method::hysteresis::LuGreLoop* worst = f.worst_described()) {
    table.rows.push_back(number_row("Of it not explained by noise (root mean square)",
                                    worst->systematic_Nm, wording::torque_scale(f.residual_Nm),
                                    "fit"));
  }
  table.note = as_sentence(f.reason);
  return table;
}

Table not_shown_table(const method::hysteresis::LuGreFit& f, const Section& section) {
  Table table;
  table.id = section.id + "-lugre-not-shown";
  table.caption = "What these loops do not show, and the experiment that would";
  table.columns = {{"Quantity", "", false, true},
                   {"Why not", "", false, true},
                   {"Next experiment", "", false, true}};
  for (const method::hysteresis::LuGreParameter& p : f.parameters) {
    if (p.estimate) continue;
    std::string why = as_sentence(p.why_not);
    if (p.held_at) why += " Held at " + wording::as_stated(*p.held_at) + " in the fit.";
    table.rows.push_back({{words.at(p.name).quantity, why, as_sentence(p.experiment)}, false});
  }
  return table;
}

Fact motion_fact(const method::hysteresis::LuGreFit& f) {
  double left = 0;
  std::size_t traced = 0;
  for (const method::hysteresis::LuGreLoop& loop : f.loops) {
    left = std::max(left, loop.motion_residual_rad);
    traced += loop.traced ? 1 : 0;
  }
  const wording::Scale angle = wording::radian_scale(left);
  const std::string leaves =
      ", which leaves up to " +
      wording::with_unit(wording::significant(left * angle.factor, few_digits), angle.unit) +
      " of the recorded angle (standard deviation)";
  if (traced == 0) return {"Motion that drives the model", "harmonics of the angle" + leaves};
  const std::string all = traced == f.loops.size()
                              ? "a smoothing spline through the angle, as it is not periodic"
                              : "harmonics of the angle, and a smoothing spline through it where "
                                "it is not periodic";
  return {"Motion that drives the model", all + leaves};
}

Table traced_table(const method::hysteresis::LuGreFit& f, double n, const Section& section) {
  Table table;
  table.id = section.id + "-lugre-traced";
  table.caption = "Loops along a spline: what is known of the motion, and how LuGre fits";
  double largest = 0;
  double stiffest = 0;
  for (const method::hysteresis::LuGreLoop& loop : f.loops) {
    if (!loop.traced) continue;
    largest = std::max({largest, loop.motion_residual_rad, loop.traced->noise_rad});
    if (loop.traced->turn_stiffness_Nm_rad) {
      stiffest = std::max(stiffest, n * loop.traced->turn_stiffness_Nm_rad->value);
    }
  }
  const wording::Scale angle = wording::radian_scale(largest);
  const wording::Scale stiffness = wording::stiffness_scale(stiffest);
  table.columns = {{"Recording", "", false, true},
                   {"Strokes", "", true},
                   {"Noise of the angle", angle.unit, true},
                   {"Left of it by the spline", angle.unit, true},
                   {"Scatter left by the fit", "N·m", true},
                   {"Explained by noise", "N·m", true},
                   {"Stiffness after a reversal, at the joint: measured", stiffness.unit, true},
                   {"of the model", stiffness.unit, true}};
  const auto stated = [&](const std::optional<statistics::Estimate>& e) {
    if (!e) return std::string("–");
    const wording::RoundedEstimate rounded =
        wording::round_by_interval(statistics::scaled(*e, n), stiffness);
    const std::string range = rounded.range();
    return range.empty() ? rounded.plus_minus() : rounded.plus_minus() + " (" + range + ")";
  };
  for (const method::hysteresis::LuGreLoop& loop : f.loops) {
    if (!loop.traced) continue;
    table.rows.push_back(
        {{log_name(loop.recording), std::to_string(loop.traced->strokes),
          wording::significant(loop.traced->noise_rad * angle.factor, few_digits),
          wording::significant(loop.motion_residual_rad * angle.factor, few_digits),
          wording::significant(loop.residual_Nm, few_digits),
          wording::significant(loop.traced->explained_Nm, few_digits),
          stated(loop.traced->turn_stiffness_Nm_rad),
          stated(loop.traced->model_turn_stiffness_Nm_rad)},
         false});
  }
  table.note =
      "Stiffness after a reversal: slope of torque over angle in the first third of each stroke's "
      "height, from the turn of the spline (95 % interval). It is up to 1.64 times the bristle "
      "stiffness σ₀ in a "
      "LuGre contact that turns from sliding, and σ₀ in one that turns long before.";
  return table;
}

Fact identifiability_fact(const method::hysteresis::LuGreIdentifiability& i) {
  std::string values;
  for (const double v : i.singular_values_Nm) {
    values += (values.empty() ? "" : ", ") + wording::significant(1e3 * v, few_digits);
  }
  return {"Singular values of the scaled Jacobian",
          values +
              "\u00a0mN·m (rms torque that a change of the parameters by their own size makes "
              "along each direction); condition " +
              wording::significant(i.condition, few_digits) +
              "; weakest: " + wording::words(i.weakest_statement)};
}

}  // namespace

void describe_lugre(const method::hysteresis::LuGreFit& f, double n, Section& section) {
  if (!f.converged) {
    section.facts.push_back({"LuGre fit of the loops", as_sentence(f.reason)});
    return;
  }
  section.facts.push_back(
      {"LuGre fit",
       std::to_string(f.loops.size()) + (f.loops.size() == 1 ? " loop" : " loops together") +
           ", motor speed up to " +
           wording::with_unit(wording::significant(f.peak_speed_rad_s, few_digits), "rad/s")});
  section.facts.push_back(motion_fact(f));
  if (!f.identifiability.names.empty()) {
    section.facts.push_back(identifiability_fact(f.identifiability));
  }
  section.tables.push_back(shown_table(f, n, section));
  section.tables.push_back(not_shown_table(f, section));
  const bool traced = std::any_of(
      f.loops.begin(), f.loops.end(),
      [](const method::hysteresis::LuGreLoop& loop) { return loop.traced.has_value(); });
  if (traced) section.tables.push_back(traced_table(f, n, section));
}

// Break-away ramps: beyond the paper's eight stages.

namespace {

Table results_table(const method::hysteresis::BreakAwayResult& r, double n,
                    const Section& section) {
  Table table;
  table.id = section.id + "-results";
  table.caption = "Break-away torque from the ramps";
  table.columns = estimate_columns();
  const auto add = [&](const std::string& quantity,
                       const std::optional<statistics::Estimate>& motor) {
    if (!motor) return;
    table.rows.push_back(estimate_row(quantity + (n == 1.0 ? "" : ", at the motor"), *motor,
                                      wording::torque_scale(motor->value)));
    if (n == 1.0) return;
    const statistics::Estimate joint = statistics::scaled(*motor, n);
    table.rows.push_back(
        estimate_row(quantity + ", at the joint", joint, wording::torque_scale(joint.value)));
  };
  const std::string with_gravity = r.gravity_taken_off ? "" : " (gravity not taken off)";
  add("Towards positive torque" + with_gravity, r.rising_Nm);
  add("Towards negative torque" + with_gravity, r.falling_Nm);
  add("Mean of both directions", r.mean_Nm);
  return table;
}

std::string outcome_words(const method::hysteresis::BreakAwayRamp& ramp,
                          const wording::Scale& travel) {
  if (!ramp.broke_away) return "censored: did not break away";
  if (!ramp.first_slip_rad) return "broke away and slid on";
  return "broke away, stopped again after " +
         wording::with_unit(wording::significant(*ramp.first_slip_rad * travel.factor, 3),
                            travel.unit);
}

Table ramps_table(const method::hysteresis::BreakAwayResult& r, const Section& section) {
  Table table;
  table.id = section.id + "-ramps";
  table.caption = "The ramps one by one";
  double furthest = 0;
  for (const method::hysteresis::BreakAwayRamp& ramp : r.ramps)
    furthest = std::max(furthest, ramp.travel_rad);
  const wording::Scale travel = wording::radian_scale(furthest);
  table.columns = {{"Recording", "", false, true},
                   {"Rate", "N·m/s", true},
                   {"Torque reached T", "N·m", true},
                   {"Friction", "N·m", true},
                   {"Pre-sliding travel", travel.unit, true},
                   {"Outcome", "", false, true}};
  for (const method::hysteresis::BreakAwayRamp& ramp : r.ramps) {
    table.rows.push_back(
        {{log_name(ramp.recording), wording::significant(ramp.rate_Nm_s, 3),
          wording::significant(ramp.torque_Nm, 4),
          (ramp.broke_away ? "" : "> ") + wording::significant(ramp.friction_Nm, 4),
          wording::significant(ramp.travel_rad * travel.factor, 3), outcome_words(ramp, travel)},
         false});
  }
  table.note =
      "Torques at the motor, travel of the joint. Censored: the ramp ended before the joint broke "
      "away; its friction is larger than the value, and the value takes no part in the means.";
  return table;
}

}  // namespace

void describe_break_away(const calibration::Calibration& c, Section& section) {
  const method::hysteresis::BreakAwayResult& r = c.break_away;
  if (r.ramps.empty()) return;
  section.facts.push_back({"Ramps", wording::count(r.ramps.size())});
  section.facts.push_back({"Of these censored", wording::count(r.censored)});
  section.facts.push_back({"Gravity", r.gravity_taken_off ? "taken off" : "not known here"});
  Table results = results_table(r, c.manifest.drive.gear_ratio(), section);
  if (!results.rows.empty()) section.tables.push_back(std::move(results));
  section.tables.push_back(ramps_table(r, section));
}

Table loop_shapes_table(const std::vector<method::hysteresis::LoopShape>& shapes, double n,
                        const Section& section) {
  Table table;
  table.id = section.id + "-shapes";
  table.caption = "The loops as they were recorded, without any model";
  if (shapes.empty()) return table;
  const wording::Scale angle = wording::radian_scale(shapes.front().width_rad);
  double stiffest = 0;
  for (const method::hysteresis::LoopShape& s : shapes) {
    if (s.stiffness_Nm_rad) stiffest = std::max(stiffest, n * s.stiffness_Nm_rad->value);
  }
  const wording::Scale stiffness = wording::stiffness_scale(stiffest);
  table.columns = {{"Recording", "", false, true},
                   {"Width", angle.unit, true},
                   {"Height, at the motor", "N·m", true},
                   {"Closing gap", "% of the width", true},
                   {"Closed", "", false},
                   {"Work per cycle, at the joint", "mJ", true},
                   {"Stiffness after a reversal, at the joint", stiffness.unit, true},
                   {"95 % interval", stiffness.unit, true}};
  for (const method::hysteresis::LoopShape& s : shapes) {
    wording::RoundedEstimate k;
    if (s.stiffness_Nm_rad)
      k = wording::round_by_interval(statistics::scaled(*s.stiffness_Nm_rad, n), stiffness);
    table.rows.push_back(
        {{log_name(s.recording), wording::significant(s.width_rad * angle.factor, 3),
          wording::significant(s.height_Nm, 3), wording::significant(100 * s.closing_gap, 2),
          s.closes ? "yes" : "no", wording::significant(1e3 * s.dissipated_J, 3),
          s.stiffness_Nm_rad ? k.plus_minus() : "–", s.stiffness_Nm_rad ? or_dash(k.range()) : "–"},
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
