// Both intervals of every quantity, and how often the paper's rule chose each point.

#include <cmath>

#include "base/requirements.h"
#include "report/view_parts.h"
#include "wording/rounding.h"
#include "wording/tr.h"
#include "wording/words.h"

namespace tribolog::report {

namespace {

using wording::to_translate;
using wording::tr;

struct Words {
  const char* name;
  const char* quantity;
  wording::Scale (*scale)(double);
};

wording::Scale kilogram(double) { return wording::plain_scale("kg"); }
wording::Scale degree(double) { return wording::degree_scale(); }
wording::Scale plain(double) { return wording::plain_scale(""); }
wording::Scale speed(double) { return wording::plain_scale("rad/s"); }
wording::Scale weakening(double) { return wording::plain_scale("N·m·s²/rad²"); }

const Words exact_names[] = {
    {"q_peak_rough_rad", to_translate("q_peak, rough sweep"), degree},
    {"q_peak_precise_rad", to_translate("q_peak, precise sweep"), degree},
    {"q_peak_rad", to_translate("q_peak, used"), degree},
    {"q_c_corrected_rad", to_translate("q_c corrected, eq. (14), with the choice of the point"),
     degree},
    {"coulomb_of_sweep_Nm", to_translate("Coulomb torque of the sweep"), wording::torque_scale},
    {"lugre.bristle_stiffness_Nm_rad", to_translate("LuGre: bristle stiffness σ0"),
     wording::stiffness_scale},
    {"lugre.bristle_damping_Nms_rad", to_translate("LuGre: bristle damping σ1"),
     wording::viscous_scale},
    {"lugre.viscous_Nms_rad", to_translate("LuGre: viscous coefficient σ2"),
     wording::viscous_scale},
    {"lugre.static_Nm", to_translate("LuGre: break-away torque Ts"), wording::torque_scale},
    {"lugre.coulomb_Nm", to_translate("LuGre: Coulomb torque Tc"), wording::torque_scale},
    {"lugre.stribeck_speed_rad_s", to_translate("LuGre: Stribeck velocity ws"), speed},
    {"lugre.speed_weakening_Nms2_rad2", to_translate("LuGre: fall with speed (Ts − Tc)/ws²"),
     weakening},
    {"lugre.inertia_kgm2", to_translate("LuGre: inertia"), wording::inertia_scale},
    {"waiboer.asperity_torque_Nm", to_translate("Eq. (6): asperity torque Ta"),
     wording::torque_scale},
    {"waiboer.stribeck_speed_rad_s", to_translate("Eq. (6): Stribeck velocity"), speed},
    {"waiboer.stribeck_power", to_translate("Eq. (6): Stribeck power δa"), plain},
    {"waiboer.viscous_coefficient", to_translate("Eq. (6): viscous coefficient cv"), plain},
    {"waiboer.viscous_power", to_translate("Eq. (6): viscous power δv"), plain},
    {"line.coulomb_Nm", to_translate("Straight line: Coulomb torque"), wording::torque_scale},
    {"line.viscous_Nms_rad", to_translate("Straight line: viscous coefficient"),
     wording::viscous_scale}};

/// The row's quantity and unit; nothing for what other rows say already (gravity says it as mass).
std::optional<std::pair<std::string, wording::Scale>> words_for(
    const method::intervals::TwoIntervals& q, double size) {
  for (const Words& words : exact_names) {
    if (q.name == words.name) return std::pair{tr(words.quantity), words.scale(size)};
  }
  const std::size_t dot = q.name.find('.');
  if (dot == std::string::npos) return std::nullopt;
  const auto named = method::hysteresis::estimator_of(q.name.substr(dot + 1));
  if (!named) return std::nullopt;
  const std::string estimator = estimator_name(*named);
  if (q.name.starts_with("mass_kg.")) {
    return std::pair{tr("Surrogate mass, {estimator}", {{"estimator", estimator}}), kilogram(size)};
  }
  if (q.name.starts_with("quality_error_percent.")) {
    return std::pair{tr("Quality error (rms), {estimator}", {{"estimator", estimator}}),
                     wording::plain_scale(tr("% of T"))};
  }
  return std::nullopt;
}

std::string range(const std::optional<statistics::Estimate>& estimate,
                  const wording::Scale& scale) {
  return estimate ? or_dash(wording::round_by_interval(*estimate, scale).range()) : "–";
}

Table intervals_table(const method::intervals::IntervalsResult& intervals) {
  Table table;
  table.id = "table-intervals";
  table.caption = tr("95 % intervals by closed form and by bootstrap");
  table.columns = {{tr("Quantity"), "", false, true}, {tr("Estimate"), "", true},
                   {tr("Unit"), "", false},           {tr("Closed form"), "", true},
                   {tr("Bootstrap"), "", true},       {tr("Ratio of widths"), "", true},
                   {tr("Stated"), "", false}};
  for (const method::intervals::TwoIntervals& q : intervals.quantities) {
    const statistics::Estimate* stated = q.stated();
    if (stated == nullptr || !std::isfinite(stated->value)) continue;
    const auto words = words_for(q, stated->value);
    if (!words) continue;
    const auto& [quantity, scale] = *words;
    const double ratio = q.ratio();
    const bool by_bootstrap = q.bootstrap && stated == &*q.bootstrap;
    table.rows.push_back({{quantity, wording::round_by_interval(*stated, scale).estimate,
                           or_dash(scale.unit), range(q.closed_form, scale),
                           range(q.bootstrap, scale), ratio > 0 ? wording::fixed(ratio, 2) : "–",
                           by_bootstrap ? tr("bootstrap") : tr("closed form")},
                          false});
  }
  table.note = tr(
      "Torques, stiffnesses and coefficients are at the motor. The interval stated is the closed "
      "form wherever its coverage was found to be as stated, the bootstrap elsewhere. Both need at "
      "least a handful of blocks; neither can detect an error that is the same in all of them.");
  return table;
}

Table choices_table(const std::vector<method::intervals::ChoiceShare>& choices) {
  Table table;
  table.id = "table-choices";
  table.caption = tr("How often the paper's rule chose each point");
  table.columns = {{tr("Point"), "", false}, {tr("Share of the resamples"), "%", true}};
  for (const method::intervals::ChoiceShare& choice : choices) {
    table.rows.push_back(
        {{to_string(choice.estimator), wording::fixed(100 * choice.share, 1)}, false});
  }
  return table;
}

}  // namespace

void add_interval_tables(const calibration::Calibration& c, Section& section) {
  const method::intervals::IntervalsResult& intervals = c.intervals;
  section.facts.push_back(
      {tr("Resamples"),
       intervals.resamples == 0
           ? tr("none: closed-form intervals only")
           : tr("{resamples}, seed {seed}", {{"resamples", wording::count(intervals.resamples)},
                                             {"seed", std::to_string(intervals.seed)}})});
  section.tables.push_back(intervals_table(intervals));
  if (!intervals.choices.empty()) section.tables.push_back(choices_table(intervals.choices));
}

// Gravity and mass by every way, the ripple, and where to oscillate next.

namespace {

/// A percentage with its sign: "+0.12".
std::string signed_percent(double percent) {
  constexpr int decimals = 3;
  return wording::with_plus_sign(wording::fixed(percent, decimals));
}

Table masses_table(const method::intervals::CrossChecksResult& r) {
  Table table;
  table.id = "table-cross-checks";
  table.caption = tr("Surrogate mass by every estimator, against the recommended one");
  table.columns = {{tr("Estimator"), "", false, true},
                   {tr("Surrogate mass"), "kg", true},
                   {tr("95 % interval, closed form"), "kg", true},
                   {tr("95 % interval, bootstrap"), "kg", true},
                   {tr("Difference"), "%", true},
                   {tr("95 % of the difference"), "± %", true},
                   {tr("In intervals"), "", true},
                   {tr("Outcome"), "", false}};
  for (std::size_t k = 0; k < r.checks.size(); ++k) {
    const method::intervals::CrossCheck& c = r.checks[k];
    const wording::RoundedEstimate closed =
        wording::round_by_interval(c.mass_kg, wording::plain_scale("kg"));
    const std::string resampled =
        c.resampled_kg
            ? wording::round_by_interval(*c.resampled_kg, wording::plain_scale("kg")).range()
            : "";
    Row row{{std::to_string(k + 1) + ". " +
                 wording::words_for("estimator", method::intervals::to_string(c.method)),
             closed.estimate, or_dash(closed.range()), or_dash(resampled)},
            c.is_recommended};
    if (c.is_recommended) {
      row.cells.insert(row.cells.end(), {"–", "–", "–", tr("recommended")});
    } else {
      row.cells.insert(row.cells.end(), {signed_percent(c.difference_percent),
                                         wording::significant(c.difference_half_width_percent, 2),
                                         wording::fixed(c.difference_in_intervals, 2),
                                         c.disagrees ? tr("disagrees") : tr("agrees")});
    }
    table.rows.push_back(row);
  }
  table.note =
      tr("Estimates from the same recordings share their errors: each difference is judged by its "
         "own interval, from resampling both together. Within that interval, or within 0.1 %, two "
         "estimators agree.");
  return table;
}

Table classical_table(const method::selection::ClassicalRegression& c) {
  Table table =
      estimates_table("table-classical", tr("The classical regression over all moving samples"));
  const double g = c.gravity_Nm.value;
  table.rows = {
      estimate_row(tr("Gravity torque G/n, at the motor"), c.gravity_Nm, wording::torque_scale(g)),
      estimate_row(tr("The same"), c.textbook_gravity_Nm, wording::torque_scale(g)),
      estimate_row(tr("Gravity peak"), c.q_peak_rad, wording::degree_scale()),
      estimate_row(tr("Coulomb torque, at the motor"), c.coulomb_Nm,
                   wording::torque_scale(c.coulomb_Nm.value)),
      estimate_row(tr("Viscous coefficient, at the motor"), c.viscous_Nms_rad,
                   wording::viscous_scale(c.viscous_Nms_rad.value)),
      estimate_row(tr("Inertia, reflected to the motor"), c.inertia_kgm2,
                   wording::inertia_scale(c.inertia_kgm2.value)),
      number_row(tr("Residual scatter of the fit"), c.residual_Nm,
                 wording::torque_scale(c.residual_Nm), tr("rows as averaged")),
      number_row(tr("Residual expected from the torque noise"), c.row_noise_Nm,
                 wording::torque_scale(c.row_noise_Nm), tr("third differences"))};
  const double times = c.row_noise_Nm > 0 ? c.residual_Nm / c.row_noise_Nm : 0.0;
  if (times > 2) {
    table.note =
        tr("Its residual scatters {ratio} times as much as the noise: friction is not a straight "
           "line in speed, and the misfit biases the parameters. The interval for independent "
           "errors does not reflect that; the one from blocks does in part.",
           {{"ratio", wording::significant(times, 2)}});
  }
  return table;
}

Table ripple_table(const method::gravity::Ripple& ripple) {
  Table table;
  table.id = "table-ripple";
  table.caption = tr("Torque ripple that the rough sweep shows");
  table.columns = {{tr("Periods per motor turn"), "", true}, {tr("Amplitude"), "mN·m", true}};
  for (const method::gravity::RippleLine& line : ripple.lines) {
    table.rows.push_back({{wording::fixed(line.periods_per_turn, 3),
                           wording::significant(1000 * line.amplitude_Nm, 3)},
                          false});
  }
  table.note =
      tr("At any motor angle it lies within ±{torque} (95 %). At a single position the loop's "
         "interval cannot be narrower.",
         {{"torque",
           wording::with_unit(wording::significant(1000 * ripple.half_width_Nm(), 2), "mN·m")}});
  return table;
}

Table plan_table(const method::hysteresis::PositionPlan& plan, const calibration::Calibration& c) {
  Table table;
  table.id = "table-positions";
  table.caption = tr("Where to oscillate next");
  table.columns = {{tr("Position"), "", true},
                   {tr("Joint angle"), "°", true},
                   {tr("From the first, at the motor"), "°", true}};
  const double first = c.hysteresis.oscillations.front().centre_rad;
  const double to_degrees = wording::degree_scale().factor;
  for (std::size_t k = 0; k < plan.further_rad.size(); ++k) {
    table.rows.push_back(
        {{std::to_string(k + 2), wording::fixed(plan.further_rad[k] * to_degrees, 4),
          wording::fixed((plan.further_rad[k] - first) * c.manifest.drive.gear_ratio() * to_degrees,
                         1)},
         false});
  }
  const double g = present(c.hysteresis.midline_Nm).value;
  const auto percent = [&](double half_width_Nm) {
    return "±" + wording::significant(100 * half_width_Nm / g, 2) + " %";
  };
  table.note =
      tr("The same oscillation at each, spread evenly over {spread}° of the motor. The mid-line's "
         "gravity torque is now known to {known_now}, of which ripple alone accounts for "
         "{of_ripple}; with all eight expect {expected}.",
         {{"spread", wording::fixed(plan.spread_motor_rad * to_degrees, 0)},
          {"known_now", percent(plan.half_width_now_Nm)},
          {"of_ripple", percent(plan.ripple_half_width_Nm)},
          {"expected", percent(plan.expected_half_width_Nm)}});
  return table;
}

}  // namespace

Section cross_checks_section(const calibration::Calibration& c) {
  Section section;
  section.id = "cross-checks";
  section.title = tr("Cross-checks and intervals");
  section.explanation = "explain_cross_checks.tpl";
  section.outcome = c.cross_checks.checks.size() < 2 ? Outcome::absent
                    : c.cross_checks.doubtful        ? Outcome::partial
                                                     : Outcome::good;
  section.status = c.cross_checks.checks.size() < 2 ? tr("nothing to compare")
                   : c.cross_checks.doubtful        ? tr("disagreement")
                                                    : tr("agreement");
  if (c.cross_checks.checks.size() < 2) {
    section.reason =
        tr("Fewer than two estimators gave a gravity torque, so there is nothing to compare.");
  }
  section.tables.push_back(masses_table(c.cross_checks));
  section.tables.push_back(ripple_table(c.rough.ripple));
  if (c.position_plan) section.tables.push_back(plan_table(*c.position_plan, c));
  if (c.cross_checks.classical) {
    section.tables.push_back(classical_table(*c.cross_checks.classical));
  }
  add_interval_tables(c, section);
  return section;
}

}  // namespace tribolog::report
