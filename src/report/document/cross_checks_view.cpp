// Gravity and mass by every estimator, the ripple, and where to oscillate next.

#include <algorithm>
#include <cmath>

#include "base/requirements.h"
#include "report/document/view_parts.h"
#include "wording/rounding.h"
#include "wording/tr.h"
#include "wording/words.h"

namespace tribolog::report::document {

namespace {

using wording::tr;

/// A percentage with its sign: "+0.12".
std::string signed_percent(double percent) {
  constexpr int decimals = 3;
  return wording::with_plus_sign(wording::fixed(percent, decimals));
}

Table masses_table(const method::selection::CrossChecksResult& r) {
  Table table;
  table.id = "table-cross-checks";
  table.caption = tr("Surrogate mass by every estimator, against the recommended one");
  table.columns = {{tr("Estimator"), "", false, true},
                   {tr("Surrogate mass"), "kg", true},
                   {tr("95 % interval"), "kg", true},
                   {tr("Difference"), "%", true},
                   {tr("95 % of the difference"), "± %", true},
                   {tr("In intervals"), "", true},
                   {tr("Outcome"), "", false}};
  for (std::size_t k = 0; k < r.checks.size(); ++k) {
    const method::selection::CrossCheck& c = r.checks[k];
    const wording::RoundedEstimate mass =
        wording::round_by_interval(c.mass_kg, wording::plain_scale("kg"));
    Row row{{std::to_string(k + 1) + ". " + wording::words_for("estimator", to_string(c.estimator)),
             mass.estimate, wording::or_dash(mass.range())},
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
  table.note = tr(
      "The model reads sweeps and runs, the others below it the oscillations. Within the interval "
      "of the difference, or within 0.1 %, two estimators agree.");
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
  section.title = tr("Cross-checks");
  section.explanation = "explain_cross_checks.tpl";
  const bool disagree =
      std::any_of(c.cross_checks.checks.begin(), c.cross_checks.checks.end(),
                  [](const method::selection::CrossCheck& one) { return one.disagrees; });
  section.outcome = c.cross_checks.checks.size() < 2 ? Outcome::absent
                    : disagree                       ? Outcome::partial
                                                     : Outcome::good;
  section.status = c.cross_checks.checks.size() < 2 ? tr("nothing to compare")
                   : disagree                       ? tr("disagreement")
                                                    : tr("agreement");
  if (c.cross_checks.checks.size() < 2) {
    section.reason =
        tr("Fewer than two estimators gave a gravity torque, so there is nothing to compare.");
  }
  section.tables.push_back(masses_table(c.cross_checks));
  section.tables.push_back(ripple_table(c.rough.ripple));
  if (c.position_plan) section.tables.push_back(plan_table(*c.position_plan, c));
  return section;
}

}  // namespace tribolog::report::document
