// Stage 8: the law of friction over the speed, and the effects beside it.

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "calibration/friction_speeds.h"
#include "report/document/view_parts.h"
#include "report/elements/result_words.h"
#include "wording/rounding.h"
#include "wording/tr.h"
#include "wording/words.h"

namespace tribolog::report::document {

namespace {

using wording::tr;

/// As a simulator takes it.
Table law_table(const method::model::ModelLaw& law, double gear_ratio, const Section& section) {
  Table table = estimates_table(
      section.id + "-law",
      at_motor(tr("Likeliest law: |T_f| = T_c + a (|ω|/ω_max)^p + b (|ω|/ω_max)² + E "
                  "exp(−(|ω|/ω_s)^δ)"),
               gear_ratio));
  const std::string from = tr("model of sweeps and runs");
  const auto torque = [&](const std::string& name, double torque_Nm) {
    table.rows.push_back(number_row(name, torque_Nm, wording::torque_scale(torque_Nm), from));
  };
  const auto plain = [&](const std::string& name, double value, const char* unit) {
    table.rows.push_back(number_row(name, value, wording::plain_scale(unit), from));
  };
  torque(tr("Coulomb torque T_c"), law.level_Nm);
  torque(tr("Viscous torque at the fastest speed, a"), law.rise_Nm);
  plain(tr("Its power p"), law.power, "");
  if (law.bend_Nm != 0) torque(tr("Quadratic torque at the fastest speed, b"), law.bend_Nm);
  if (law.dip_rad_s > 0) {
    torque(tr("Stribeck excess E"), law.excess_Nm);
    plain(tr("Stribeck velocity ω_s"), law.dip_rad_s, "rad/s");
    plain(tr("Stribeck power δ"), law.dip_power, "");
  }
  plain(tr("Fastest speed ω_max"), law.fastest_rad_s, "rad/s");
  table.note =
      tr("Valid from {slowest} to {fastest}. Numbers with intervals are the friction torques at "
         "stated speeds: they hold every law that the recordings do not exclude.",
         {{"slowest", wording::with_unit(wording::significant(law.slowest_rad_s, 3), "rad/s")},
          {"fastest", wording::with_unit(wording::significant(law.fastest_rad_s, 3), "rad/s")}});
  return table;
}

/// Friction while the angle rises and while it falls, at a few speeds; no rows: none is known.
Table direction_table(const calibration::Calibration& c, const Section& section) {
  Table table;
  table.id = section.id + "-directions";
  table.caption = at_motor(tr("Friction by direction"), c.manifest.drive.gear_ratio());
  double largest_Nm = 0;
  for (const calibration::FrictionAtSpeed& f : c.judgement.friction_at_speed) {
    largest_Nm = std::max(largest_Nm, f.torque_Nm.value);
  }
  const wording::Scale scale = wording::torque_scale(largest_Nm);
  table.columns = {{tr("Motor speed"), "rad/s", true},
                   {tr("Angle rises"), scale.unit, true},
                   {tr("Angle falls"), scale.unit, true},
                   {tr("Mean"), scale.unit, true}};
  const auto shown = [&](const statistics::Estimate& e) {
    return wording::round_by_interval(
               statistics::symmetric_estimate(e.value, std::max(e.high - e.value, e.value - e.low)),
               scale)
        .plus_minus();
  };
  constexpr int digits = 3;
  for (const calibration::FrictionAtSpeed& f :
       calibration::of_a_table(c.judgement.friction_at_speed)) {
    if (!f.forward_Nm || !f.backward_Nm) continue;
    table.rows.push_back({{wording::significant(f.speed_rad_s, digits), shown(*f.forward_Nm),
                           shown(*f.backward_Nm), shown(f.torque_Nm)},
                          false});
  }
  table.note =
      tr("What the drive gives beside gravity and acceleration. An offset of the torque is in both "
         "directions, with opposite signs: no motion tells it from friction that differs. What "
         "both share, such as a scale of the torque, is in all three columns.");
  return table;
}

/// Candidate laws, likeliest first.
Table candidates_table(const method::model::ModelLaw& law, const Section& section) {
  Table table;
  table.id = section.id + "-forms";
  table.caption = tr("Candidate laws");
  table.columns = {{tr("Law"), "", false, true}, {tr("Probability"), "", true}};
  for (const method::model::CandidateLaw& one : law.candidates) {
    table.rows.push_back(
        {{wording::capitalised(described(one.law)), elements::share_in_words(one.probability)},
         table.rows.empty()});
  }
  table.note =
      tr("Lines, parabolas and powers of the speed, with and without a Stribeck dip of any speed, "
         "are compared by their evidence; laws not listed have none.");
  return table;
}

Table waiboer_table(const method::viscous::WaiboerFit& f, const method::model::ModelLaw& law,
                    double gear_ratio, const Section& section) {
  Table table = estimates_table(
      section.id + "-waiboer",
      at_motor(tr("Friction of a geared joint after Waiboer et al., eq. (6)"), gear_ratio));
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
  else if (!law.empty() && !law.carries_waiboer())
    table.note = tr(
        "The recordings do not support all five: with {dip} there is a Stribeck dip, with {bend} a "
        "viscous torque out of proportion to the speed.",
        {{"dip", elements::share_in_words(law.dip_probability)},
         {"bend", elements::share_in_words(law.bend_probability)}});
  return table;
}

/// What the one model takes off beside gravity, inertia and the law of friction.
Table effects_table(const method::model::ModelResult& model, double gear_ratio,
                    const Section& section) {
  Table table =
      estimates_table(section.id + "-effects",
                      at_motor(tr("Effects in the torque, each where it is largest"), gear_ratio));
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

void describe_parameters(const calibration::Calibration& c, Section& section) {
  const double n = c.manifest.drive.gear_ratio();
  const method::selection::FrictionParametersResult& f = c.friction;
  if (f.curve) {
    section.facts.push_back(
        {tr("Curve fitted"),
         tr("that of {estimator}", {{"estimator", elements::estimator_name(*f.curve)}})});
  }
  const method::model::ModelLaw& law = c.model.law;
  if (!law.empty()) {
    section.facts.push_back({tr("Law of friction"), wording::words(described(law))});
    section.tables.push_back(law_table(law, n, section));
    section.tables.push_back(candidates_table(law, section));
  }
  if (Table directions = direction_table(c, section); !directions.rows.empty()) {
    section.tables.push_back(std::move(directions));
  }
  const Table effects = effects_table(c.model, n, section);
  if (!effects.rows.empty()) section.tables.push_back(effects);
  if (f.waiboer) section.tables.push_back(waiboer_table(*f.waiboer, law, n, section));
  if (c.lugre) describe_lugre(*c.lugre, n, section);
}

}  // namespace tribolog::report::document
