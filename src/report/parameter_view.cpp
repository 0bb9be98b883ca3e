// Stage 8.

#include <cmath>
#include <string>

#include "report/view_parts.h"
#include "wording/rounding.h"
#include "wording/tr.h"
#include "wording/words.h"

namespace tribolog::report {

namespace {

using wording::tr;

Table line_table(const method::selection::CoulombViscousFit& f, double n, const Section& section) {
  Table table =
      estimates_table(section.id + "-line", tr("Straight line beyond the dip: |T_f| = a + b |ω|"));
  add_both_sides(tr("Where it meets ω = 0, a"), f.coulomb_Nm, {n, n}, wording::torque_scale, table);
  add_both_sides(tr("Slope b"), f.viscous_Nms_rad, {n, n * n}, wording::viscous_scale, table);
  table.rows.push_back(number_row(tr("Residual scatter of the fit (standard deviation)"),
                                  f.residual_Nm, wording::torque_scale(f.residual_Nm), tr("fit")));
  constexpr int digits = 3;
  table.note =
      tr("Fitted to motor speeds from {slowest} to {fastest}, beyond the Stribeck dip; not valid "
         "below.",
         {{"slowest", wording::significant(f.slowest_rad_s, digits)},
          {"fastest", wording::with_unit(wording::significant(f.fastest_rad_s, digits), "rad/s")}});
  return table;
}

Table sliding_table(const method::viscous::SlidingLaw& law, double n, const Section& section) {
  Table table = estimates_table(section.id + "-sliding",
                                tr("Sliding law: |T_f| = T_c + E exp(−(ω/ω_s)^δ) + c |ω|"));
  if (law.coulomb_Nm.estimate) {
    add_both_sides(tr("Coulomb torque T_c"), *law.coulomb_Nm.estimate, {n, n},
                   wording::torque_scale, table);
  }
  if (law.stribeck_speed_rad_s.estimate) {
    table.rows.push_back(estimate_row(tr("Stribeck velocity ω_s"),
                                      *law.stribeck_speed_rad_s.estimate,
                                      wording::plain_scale("rad/s")));
  }
  if (law.viscous_Nms_rad.estimate) {
    add_both_sides(tr("Viscous coefficient c"), *law.viscous_Nms_rad.estimate, {n, n * n},
                   wording::viscous_scale, table);
  }
  table.rows.push_back(number_row(tr("Scatter between speeds, beyond that within the runs"),
                                  law.scatter_Nm, wording::torque_scale(law.scatter_Nm),
                                  tr("fit")));
  table.note =
      tr("An interval holds what every law says that the speeds do not exclude; exponents δ from "
         "{low} to {high} are among them.",
         {{"low", wording::significant(law.lowest_exponent, 2)},
          {"high", wording::significant(law.highest_exponent, 2)}});
  return table;
}

Table waiboer_table(const method::viscous::WaiboerFit& f, const Section& section) {
  Table table =
      estimates_table(section.id + "-waiboer",
                      tr("Friction of a geared joint after Waiboer et al., eq. (6), at the motor"));
  table.rows = {estimate_row(tr("Asperity torque T_a"), f.asperity_torque_Nm,
                             wording::torque_scale(f.asperity_torque_Nm.value)),
                estimate_row(tr("Stribeck velocity ω_s"), f.stribeck_speed_rad_s,
                             wording::plain_scale("rad/s")),
                estimate_row(tr("Stribeck power δ_a"), f.stribeck_power, wording::plain_scale("")),
                estimate_row(tr("Viscous coefficient c_v"), f.viscous_coefficient,
                             wording::plain_scale("N·m·(s/rad)^(1−δ_v)")),
                estimate_row(tr("Viscous power δ_v"), f.viscous_power, wording::plain_scale("")),
                number_row(tr("Residual scatter of the fit (standard deviation)"), f.residual_Nm,
                           wording::torque_scale(f.residual_Nm), tr("fit"))};
  if (!f.converged)
    table.note = tr("The fit did not converge: these are its last values, not results.");
  return table;
}

}  // namespace

void describe_parameters(const calibration::Calibration& c, Section& section) {
  const double n = c.manifest.drive.gear_ratio();
  const method::selection::FrictionParametersResult& f = c.friction;
  if (f.curve) {
    section.facts.push_back(
        {tr("Curve fitted"), tr("that of {estimator}", {{"estimator", estimator_name(*f.curve)}})});
  }
  describe_curve_models(c, section);
  const method::viscous::SlidingLaw& law = c.curve_model.sliding;
  if (law.fitted) section.tables.push_back(sliding_table(law, n, section));
  if (f.waiboer) section.tables.push_back(waiboer_table(*f.waiboer, section));
  if (f.coulomb_viscous) section.tables.push_back(line_table(*f.coulomb_viscous, n, section));
  if (c.lugre) describe_lugre(*c.lugre, n, section);
}

// Stage 8: the ladder of models, and the effects of the one model.

namespace {

constexpr int digits = 3;

Row trial_row(const method::viscous::CurveModelTrial& t, bool is_chosen) {
  const bool took_part = t.excluded_because.empty();
  return {
      {wording::words(method::viscous::described(t.model)), std::to_string(t.model.parameters()),
       took_part ? wording::significant(t.training_rms_Nm, digits) : "–",
       took_part ? wording::significant(t.held_out_rms_Nm, digits) : "–",
       is_chosen   ? tr("chosen")
       : took_part ? or_dash("")
                   : tr("excluded: {reason}", {{"reason", t.excluded_because}})},
      is_chosen};
}

Table trials_table(const std::string& id, const std::string& caption) {
  Table table;
  table.id = id;
  table.caption = caption;
  table.columns = {{tr("Model"), "", false, true},
                   {tr("Parameters"), "", true},
                   {tr("Error on its own data"), "N·m", true},
                   {tr("Error at held-out speeds"), "N·m", true},
                   {tr("Outcome"), "", false, true}};
  return table;
}

Table ladder_table(const method::viscous::CurveModelChoice& c, const Section& section) {
  Table table =
      trials_table(section.id + "-ladder", tr("Which model the curve supports, at the motor"));
  for (const method::viscous::CurveModelTrial& t : c.ladder) {
    table.rows.push_back(trial_row(t, t.model.law == c.chosen.law));
  }
  table.note = as_sentence(c.sentence) + " " + as_sentence(c.five_sentence) + " " +
               tr("The simplest model whose error at held-out speeds lies within one standard "
                  "error of the best is chosen.");
  return table;
}

Table options_table(const method::viscous::CurveModelChoice& c, const Section& section) {
  Table table = trials_table(section.id + "-terms", tr("Terms for direction and load"));
  for (const method::viscous::CurveModelTrial& t : c.options) {
    table.rows.push_back(trial_row(t, false));
    const bool is_taken = t.model.asymmetry == c.chosen.asymmetry && t.model.load == c.chosen.load;
    if (t.excluded_because.empty())
      table.rows.back().cells.back() = is_taken ? tr("included") : "–";
  }
  table.note =
      tr("A term is included only if it reduces the error at held-out speeds by more than twice "
         "the standard error of the gain.");
  return table;
}

Table parameters_table(const method::viscous::CurveModelChoice& c, const Section& section) {
  Table table = estimates_table(section.id + "-model",
                                tr("Parameters of the chosen model: {model}, at the motor",
                                   {{"model", method::viscous::described(c.chosen)}}));
  for (const method::viscous::CurveParameter& p : c.parameters) {
    const std::string unit = p.unit_as.empty() ? p.unit : wording::words(p.unit_as);
    table.rows.push_back(estimate_row(
        wording::words(p.title), p.estimate,
        unit == "N·m" ? wording::torque_scale(p.estimate.value) : wording::plain_scale(unit)));
  }
  return table;
}

/// What the one model takes off beside gravity, inertia and the law of friction.
Table effects_table(const method::model::ModelResult& model, const Section& section) {
  Table table = estimates_table(
      section.id + "-effects", tr("Effects in the torque, each where it is largest, at the motor"));
  for (const method::model::ModelEffect& effect : model.effects) {
    if (std::isnan(effect.chi2)) continue;
    table.rows.push_back(
        estimate_row(wording::capitalised(wording::words_for("effect", std::string(effect.key))),
                     effect.largest_Nm, wording::torque_scale(effect.largest_Nm.value)));
  }
  table.note =
      tr("All are in the model of sweeps, runs and points, each with a typical size beforehand: "
         "what the recordings show of it is taken off, and what they cannot exclude is in the "
         "intervals.");
  return table;
}

}  // namespace

void describe_curve_models(const calibration::Calibration& c, Section& section) {
  const method::viscous::CurveModelChoice& model = c.curve_model;
  if (model.chosen_any) {
    section.facts.push_back(
        {tr("Model of the curve"), wording::words(method::viscous::described(model.chosen))});
    section.tables.push_back(ladder_table(model, section));
    section.tables.push_back(options_table(model, section));
    section.tables.push_back(parameters_table(model, section));
  } else if (!model.sentence.empty() && !c.viscous.runs.empty()) {
    section.facts.push_back({tr("Model of the curve"), as_sentence(model.sentence)});
  }
  const Table effects = effects_table(c.model, section);
  if (!effects.rows.empty()) section.tables.push_back(effects);
}

}  // namespace tribolog::report
