// Stage 8: what the hysteresis loops alone show of LuGre.

#include <algorithm>
#include <cmath>
#include <map>

#include "report/document/view_parts.h"
#include "report/elements/result_words.h"
#include "wording/rounding.h"
#include "wording/tr.h"
#include "wording/words.h"

namespace tribolog::report::document {

namespace {

using method::hysteresis::LuGreParameterName;
using wording::to_translate;
using wording::tr;
using wording::tr_count;

constexpr int few_digits = 3;

struct LuGreWords {
  const char* quantity;
  int torque_powers;  ///< Factors n from motor to joint.
  wording::Scale (*scale)(double);
};

wording::Scale weakening_scale(double) { return wording::plain_scale("N·m·s²/rad²"); }
wording::Scale speed_scale(double) { return wording::plain_scale("rad/s"); }

const std::map<LuGreParameterName, LuGreWords> words{
    {LuGreParameterName::bristle_stiffness,
     {to_translate("Bristle stiffness σ₀"), 2, wording::stiffness_scale}},
    {LuGreParameterName::bristle_damping,
     {to_translate("Bristle damping σ₁"), 2, wording::viscous_scale}},
    {LuGreParameterName::viscous,
     {to_translate("Viscous coefficient σ₂"), 2, wording::viscous_scale}},
    {LuGreParameterName::static_torque,
     {to_translate("Break-away torque T_s"), 1, wording::torque_scale}},
    {LuGreParameterName::coulomb_torque,
     {to_translate("Coulomb torque T_c"), 1, wording::torque_scale}},
    {LuGreParameterName::stribeck_speed, {to_translate("Stribeck velocity ω_s"), -1, speed_scale}},
    {LuGreParameterName::speed_weakening,
     {to_translate("Start of the fall of friction with speed"), 3, weakening_scale}},
    {LuGreParameterName::inertia,
     {to_translate("Inertia J of motor, gear and arm"), 2, wording::inertia_scale}}};

void add_parameter(const LuGreWords& quantity, const statistics::Estimate& motor, double n,
                   Table& table) {
  add_both_sides(tr(quantity.quantity), motor, {n, std::pow(n, quantity.torque_powers)},
                 quantity.scale, table);
}

Table shown_table(const method::hysteresis::LuGreFit& f, double n, const Section& section) {
  Table table = estimates_table(section.id + "-lugre",
                                tr("LuGre model, fitted to the hysteresis loops alone"));
  for (const method::hysteresis::LuGreParameter& p : f.parameters) {
    const LuGreWords& w = words.at(p.name);
    if (p.estimate) {
      add_parameter(w, *p.estimate, n, table);
    } else {
      table.rows.push_back(not_identified_row(tr(w.quantity), tr("not shown by this excitation")));
    }
  }
  if (f.gravity_Nm) {
    add_both_sides(tr("Gravity torque at the peak"), *f.gravity_Nm, {n, n}, wording::torque_scale,
                   table);
  }
  table.rows.push_back(number_row(tr("Residual scatter of the fit (standard deviation)"),
                                  f.residual_Nm, wording::torque_scale(f.residual_Nm), tr("fit")));
  if (const method::hysteresis::LuGreLoop* worst = f.worst_described()) {
    table.rows.push_back(number_row(tr("Residual not explained by noise (root mean square)"),
                                    worst->systematic_Nm, wording::torque_scale(f.residual_Nm),
                                    tr("fit")));
  }
  table.note = wording::as_sentence(f.reason);
  return table;
}

Table not_shown_table(const method::hysteresis::LuGreFit& f, const Section& section) {
  Table table;
  table.id = section.id + "-lugre-not-shown";
  table.caption = tr("What these loops do not show, and the experiment that would");
  table.columns = {{tr("Quantity"), "", false, true},
                   {tr("Why not"), "", false, true},
                   {tr("Next experiment"), "", false, true}};
  for (const method::hysteresis::LuGreParameter& p : f.parameters) {
    if (p.estimate) continue;
    std::string why = wording::as_sentence(p.why_not);
    if (p.held_at) {
      why += " " + tr("Held at {value} in the fit.", {{"value", wording::as_stated(*p.held_at)}});
    }
    table.rows.push_back(
        {{tr(words.at(p.name).quantity), why, wording::as_sentence(p.experiment)}, false});
  }
  return table;
}

/// @param angle that the motion leaves of the recorded one.
std::string motion_in_words(std::size_t traced, std::size_t loops, const std::string& angle) {
  if (traced == 0) {
    return tr(
        "harmonics of the angle, which leaves up to {angle} of the recorded angle (standard "
        "deviation)",
        {{"angle", angle}});
  }
  if (traced == loops) {
    return tr(
        "a smoothing spline through the angle, as it is not periodic, which leaves up to {angle} "
        "of the recorded angle (standard deviation)",
        {{"angle", angle}});
  }
  return tr(
      "harmonics of the angle, and a smoothing spline through it where it is not periodic, which "
      "leaves up to {angle} of the recorded angle (standard deviation)",
      {{"angle", angle}});
}

Fact motion_fact(const method::hysteresis::LuGreFit& f) {
  double left = 0;
  std::size_t traced = 0;
  for (const method::hysteresis::LuGreLoop& loop : f.loops) {
    left = std::max(left, loop.motion_residual_rad);
    traced += loop.traced ? 1 : 0;
  }
  const wording::Scale angle = wording::radian_scale(left);
  return {tr("Motion that drives the model"),
          motion_in_words(traced, f.loops.size(),
                          wording::with_unit(wording::significant(left * angle.factor, few_digits),
                                             angle.unit))};
}

Table traced_table(const method::hysteresis::LuGreFit& f, double n, const Section& section) {
  Table table;
  table.id = section.id + "-lugre-traced";
  table.caption = tr("Loops along a spline: what is known of the motion, and how LuGre fits");
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
  table.columns = {{tr("Recording"), "", false, true},
                   {tr("Strokes"), "", true},
                   {tr("Noise of the angle"), angle.unit, true},
                   {tr("Residual of the spline"), angle.unit, true},
                   {tr("Residual scatter of the fit"), "N·m", true},
                   {tr("Explained by noise"), "N·m", true},
                   {tr("Stiffness after a reversal, at the joint: measured"), stiffness.unit, true},
                   {tr("of the model"), stiffness.unit, true}};
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
        {{elements::log_name(loop.recording), std::to_string(loop.traced->strokes),
          wording::significant(loop.traced->noise_rad * angle.factor, few_digits),
          wording::significant(loop.motion_residual_rad * angle.factor, few_digits),
          wording::significant(loop.residual_Nm, few_digits),
          wording::significant(loop.traced->explained_Nm, few_digits),
          stated(loop.traced->turn_stiffness_Nm_rad),
          stated(loop.traced->model_turn_stiffness_Nm_rad)},
         false});
  }
  table.note =
      tr("Stiffness after a reversal: slope of torque over angle in the first third of each "
         "stroke's height, from the reversal of the spline (95 % interval). It is up to 1.64 times "
         "the bristle stiffness σ₀ in a LuGre contact that reverses from sliding, and σ₀ in one "
         "that reverses long before.");
  return table;
}

Fact identifiability_fact(const method::hysteresis::LuGreIdentifiability& i) {
  std::string values;
  for (const double v : i.singular_values_Nm) {
    values += (values.empty() ? "" : ", ") + wording::significant(1e3 * v, few_digits);
  }
  return {tr("Singular values of the scaled Jacobian"),
          tr("{singular_values} (rms torque that a change of the parameters by their own size "
             "makes along each direction); condition number {condition}; weakest: {parameters}",
             {{"singular_values", wording::with_unit(values, "mN·m")},
              {"condition", wording::significant(i.condition, few_digits)},
              {"parameters", i.weakest_statement}})};
}

}  // namespace

void describe_lugre(const method::hysteresis::LuGreFit& f, double n, Section& section) {
  if (!f.converged) {
    section.facts.push_back({tr("LuGre fit of the loops"), wording::as_sentence(f.reason)});
    return;
  }
  section.facts.push_back(
      {tr("LuGre fit"),
       tr_count(f.loops.size(), "{loops} loop, motor speed up to {speed}",
                "{loops} loops together, motor speed up to {speed}",
                {{"loops", f.loops.size()},
                 {"speed", wording::with_unit(wording::significant(f.peak_speed_rad_s, few_digits),
                                              "rad/s")}})});
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
  Table table = estimates_table(section.id + "-results", tr("Break-away torque from the ramps"));
  const auto add = [&](const std::string& quantity,
                       const std::optional<statistics::Estimate>& motor) {
    if (motor) add_both_sides(quantity, *motor, {n, n}, wording::torque_scale, table);
  };
  add(r.gravity ? tr("Towards positive torque")
                : tr("Towards positive torque (gravity not subtracted)"),
      r.rising_Nm);
  add(r.gravity ? tr("Towards negative torque")
                : tr("Towards negative torque (gravity not subtracted)"),
      r.falling_Nm);
  add(tr("Mean of both directions"), r.mean_Nm);
  return table;
}

std::string outcome_words(const method::hysteresis::BreakAwayRamp& ramp,
                          const wording::Scale& travel) {
  if (!ramp.broke_away) return tr("censored: did not break away");
  if (ramp.even_slide_rad_s) return tr("slid on at an even speed");
  if (!ramp.first_slip_rad) return tr("broke away and slid on");
  return tr(
      "broke away, stopped again after {travel}",
      {{"travel", wording::with_unit(wording::significant(*ramp.first_slip_rad * travel.factor, 3),
                                     travel.unit)}});
}

Table ramps_table(const method::hysteresis::BreakAwayResult& r, double n, const Section& section) {
  Table table;
  table.id = section.id + "-ramps";
  table.caption = at_motor(tr("The ramps one by one"), n);
  double furthest = 0;
  for (const method::hysteresis::BreakAwayRamp& ramp : r.ramps)
    furthest = std::max(furthest, ramp.travel_rad);
  const wording::Scale travel = wording::radian_scale(furthest);
  table.columns = {{tr("Recording"), "", false, true},
                   {tr("Rate"), "N·m/s", true},
                   {tr("Torque reached T"), "N·m", true},
                   {tr("Friction"), "N·m", true},
                   {tr("Pre-sliding travel"), travel.unit, true},
                   {tr("Outcome"), "", false, true}};
  for (const method::hysteresis::BreakAwayRamp& ramp : r.ramps) {
    table.rows.push_back(
        {{elements::log_name(ramp.recording), wording::significant(ramp.rate_Nm_s, 3),
          wording::significant(ramp.torque_Nm, 4),
          (ramp.broke_away ? "" : "> ") + wording::significant(ramp.friction_Nm, 4),
          wording::significant(ramp.travel_rad * travel.factor, 3), outcome_words(ramp, travel)},
         false});
  }
  table.note =
      tr("Travel is the joint's. Censored: the ramp ended before the joint "
         "broke away; its friction is larger than the value, which is left out of the means.");
  return table;
}

}  // namespace

void describe_break_away(const calibration::Calibration& c, Section& section) {
  const method::hysteresis::BreakAwayResult& r = c.break_away;
  if (r.ramps.empty()) return;
  section.facts.push_back({tr("Ramps"), wording::count(r.ramps.size())});
  section.facts.push_back({tr("Of these censored"), wording::count(r.censored)});
  section.facts.push_back({tr("Gravity"), r.gravity ? tr("subtracted") : tr("not known here")});
  Table results = results_table(r, c.manifest.drive.gear_ratio(), section);
  if (!results.rows.empty()) section.tables.push_back(std::move(results));
  section.tables.push_back(ramps_table(r, c.manifest.drive.gear_ratio(), section));
}

Table loop_shapes_table(const std::vector<method::hysteresis::LoopShape>& shapes, double n,
                        const Section& section) {
  Table table;
  table.id = section.id + "-shapes";
  table.caption = tr("The loops as recorded, without any model");
  if (shapes.empty()) return table;
  const wording::Scale angle = wording::radian_scale(shapes.front().width_rad);
  double stiffest = 0;
  for (const method::hysteresis::LoopShape& s : shapes) {
    if (s.stiffness_Nm_rad) stiffest = std::max(stiffest, n * s.stiffness_Nm_rad->value);
  }
  const wording::Scale stiffness = wording::stiffness_scale(stiffest);
  table.columns = {{tr("Recording"), "", false, true},
                   {tr("Width"), angle.unit, true},
                   {at_motor(tr("Height"), n), "N·m", true},
                   {tr("Closing gap"), tr("% of the width"), true},
                   {tr("Closed"), "", false},
                   {at_joint(tr("Work per cycle"), n), "mJ", true},
                   {at_joint(tr("Stiffness after a reversal"), n), stiffness.unit, true},
                   {tr("95 % interval"), stiffness.unit, true}};
  for (const method::hysteresis::LoopShape& s : shapes) {
    wording::RoundedEstimate k;
    if (s.stiffness_Nm_rad)
      k = wording::round_by_interval(statistics::scaled(*s.stiffness_Nm_rad, n), stiffness);
    table.rows.push_back(
        {{elements::log_name(s.recording), wording::significant(s.width_rad * angle.factor, 3),
          wording::significant(s.height_Nm, 3), wording::significant(100 * s.closing_gap, 2),
          s.closes ? tr("yes") : tr("no"), wording::significant(1e3 * s.dissipated_J, 3),
          s.stiffness_Nm_rad ? k.plus_minus() : "–",
          s.stiffness_Nm_rad ? wording::or_dash(k.range()) : "–"},
         false});
  }
  table.note =
      tr("Closing gap: mean distance of the angle from where it was one cycle earlier; a loop "
         "counts as closed up to 5 %. Stiffness: slope of torque over angle in the first third of "
         "the loop's height after a reversal; the tangent at the reversal itself is up to 1.2 "
         "times larger in a LuGre contact.");
  return table;
}

}  // namespace tribolog::report::document
