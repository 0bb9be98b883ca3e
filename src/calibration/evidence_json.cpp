// What stands behind the numbers: checks on the data before any fit, the verdict, and intervals.

#include <cmath>
#include <optional>
#include <string>

#include "calibration/parts.h"
#include "wording/torques_in.h"

namespace tribolog::calibration {

void state_data_checks(Fields& f, const method::checks::DataChecksResult& result) {
  f.list("data_checks", result.checks, "Checks on the recordings before any fit.",
         [](Fields& one, const method::checks::DataCheck& check) {
           const std::string name(to_string(check.name));
           one.text("name", name);
           one.words_for("title", "check", name);
           one.choice("state", check.state);
           one.text_or_null("recording", check.recording + (check.is_of_whole_role ? ", all" : ""),
                            "The one that the number is of, or all.");
           one.words_or_null("measure", check.measure);
           one.number("measured", check.measured);
           one.number("at_least", check.at_least);
           one.number("at_most", check.at_most);
           one.text_or_null("unit", wording::shown_units(check.unit));
           one.words_or_null("found", check.found);
           one.words_or_null("consequence", check.consequence);
           one.words_or_null("experiment", check.experiment);
         });
}

// The known-truth check.

namespace {

void state_returned(Fields& f, const ReturnedQuantity& q) {
  f.text("name", std::string(to_string(q.name)),
         "AB, CD, EF, midline, sweep, fit: gravity torque at the motor by that estimator; else the "
         "quantity's own name.");
  f.text("unit", wording::shown_units(q.unit), "Empty: a pure number.");
  f.number("put_in", q.put_in);
  f.number("came_back", q.came_back, "Mean over the runs.");
  f.number("scatter", q.scatter, "Standard deviation over the runs.");
  f.number("half_width", q.half_width, "Mean half width of the stated 95 % intervals.");
  f.count("found", q.found, "Runs in which it was found.");
  f.count("inside", q.inside, "Runs whose stated interval holds what was put in.");
  f.numbers("in_half_widths", q.in_half_widths, "(came back - put in) / half width, run by run.");
  f.flag("comes_back", q.comes_back);
}

}  // namespace

void state_truth_check(Fields& f, const TruthCheckResult& t) {
  f.object_or_null("truth_check", t.runs == 0 ? nullptr : &t,
                   "The known-truth check: what was identified, simulated at the noise found and "
                   "identified again. Null where it was not made.",
                   [](Fields& of, const TruthCheckResult& made) {
                     of.put("runs", Json(made.runs), R"({"type": "integer", "minimum": 1})");
                     of.count("seed", made.seed);
                     of.object("noise",
                               "Found in the recordings, motor side: white noise and ripple as "
                               "standard deviations, the step of the torque (0: continuous).",
                               [&](Fields& noise) {
                                 noise.number("white_Nm", made.white_Nm);
                                 noise.number("torque_step_Nm", made.torque_step_Nm);
                                 noise.number("ripple_Nm", made.ripple_Nm);
                               });
                     of.list("quantities", made.quantities, "", state_returned);
                     of.words("left_out", made.left_out, "What could not be simulated, and why.");
                     std::vector<Statement> findings;
                     for (const TruthFinding& one : made.findings) findings.push_back(one.finding);
                     of.words("findings", findings, "What does not come back.");
                   });
}

// The verdict: overall, on each quantity, and against the manifest's limits.

namespace {

void state_limit(Fields& f, const LimitOutcome& o) {
  f.text("quantity", o.key);
  f.choice("rule", o.rule);
  f.known_number("limit", o.limit);
  f.text("unit", o.unit);
  f.interval("estimate", o.estimate);
  f.choice(
      "state", o.state,
      "crosses: the interval lies on both sides, so that it is not shown that the limit is kept.");
  f.words("words", o.outcome);
}

void state_rule(Fields& f, const RuleOutcome& o) {
  std::vector<std::string> quantities;
  for (const joint::Quantity quantity : o.quantities) quantities.emplace_back(to_string(quantity));
  f.text("rule", o.rule);
  f.newer().words_for("words", "rule", o.rule);
  f.choice("state", o.state);
  f.number("value", o.value);
  f.known_number("threshold", o.threshold);
  f.newer().text_or_null("unit", wording::shown_units(o.unit));
  f.texts("quantities", quantities, "That a broken rule lowers.");
  f.choice("lowers_to", o.lowers_to);
  f.newer().words_or_null("finding", o.finding);
}

/// Nothing: infinite.
std::optional<double> freedom(double degrees) {
  return std::isinf(degrees) ? std::nullopt : std::optional(degrees);
}

void state_part(Fields& f, const BudgetPart& part) {
  f.choice("influence", part.influence);
  f.put("type", part.is_type_b ? "B" : "A", R"({"enum": ["A", "B"]})");
  f.put("id", part.is_type_b ? Json(part.id) : Json(nullptr), R"({"type": ["string", "null"]})",
        "What the error comes from: calibrations with the same text share it, and it cancels in "
        "their comparison. null: type A.");
  f.number("stated", part.stated,
           "Half width at 95 % from the manifest: percent, or degrees of the angle's zero.");
  f.known_number("sensitivity", part.sensitivity,
                 "Relative change of the quantity by that of the influence.");
  f.known_number("standard_uncertainty", part.standard_uncertainty, "In the quantity's unit.");
  f.number("degrees_of_freedom", freedom(part.freedom), "null: infinite.");
  f.known_number("share", part.share, "Of the combined variance.");
}

void state_effect(Fields& f, const BudgetEffect& one) {
  f.text("effect", one.effect);
  f.known_number("share", one.share);
  f.number("size", one.unit.empty() ? std::nullopt : std::optional(one.size),
           "As stated, or as is typical, in `unit`; null: it has none.");
  f.put("unit", text_or_null(wording::shown_units(one.unit)),
        R"({"enum": ["percent", "ms", "mrad", null]})");
  f.flag("is_stated", one.is_stated);
}

void state_budget(Fields& f, const UncertaintyBudget& b) {
  std::vector<std::string> not_stated;
  for (const Influence influence : b.not_stated) not_stated.emplace_back(to_string(influence));
  f.list("parts", b.parts, "The largest first.", state_part);
  f.list("effects", b.effects,
         "Of the part `recordings`: what would go of its variance if the size of an effect of the "
         "one model were known, the largest first. Effects that the recordings cannot tell from "
         "one another overlap.",
         state_effect);
  f.texts("not_included", not_stated,
          "Influences that bear upon the quantity, and of which the manifest says nothing.");
  f.known_number("standard_uncertainty", b.standard_uncertainty, "Combined.");
  f.number("degrees_of_freedom", freedom(b.freedom),
           "Effective (Welch-Satterthwaite); null: infinite.");
  f.known_number("coverage_factor", b.coverage_factor, "Student's t at 95 %.");
  f.put("expanded", interval(b.expanded), R"({"$ref": "#/$defs/estimate"})");
}

void state_quantity(Fields& f, const QuantityVerdict& q) {
  const std::string key(to_string(q.quantity));
  f.text("key", key);
  f.words_for("words", "quantity", key);
  f.choice("verdict", q.verdict);
  f.flag("decides", q.decides, "Takes part in the verdict over all.");
  f.words("reasons", q.reasons, "The weightiest first; empty only if usable.");
  f.words_or_null("experiment", q.experiment, "What to record next.");
  f.interval("estimate", q.estimate);
  f.text_or_null("unit", wording::shown_units(q.unit),
                 "Of the estimate; SI, motor side. With drive.torque_is_in_amperes that of a "
                 "current: A, A/rad, A·s/rad, A·s²/rad.");
  f.newer().object_or_null("budget", q.budget,
                           "The uncertainty budget after JCGM 100; null without an estimate.",
                           state_budget);
  f.list("limits", q.limits,
         "The manifest's [[limit]] tables that speak of it, one entry for each number.",
         state_limit);
}

}  // namespace

void state_verdict(Fields& f, const Judgement& judgement) {
  f.choice("verdict", judgement.verdict);
  f.words("sentence", judgement.sentence);
  f.words("findings", judgement.findings, "Most important first.");
  f.newer().list("rules", judgement.rules,
                 "The verdict's rules: what was found in the data, against the threshold above "
                 "which a rule is broken.",
                 state_rule);
  f.list("quantities", judgement.quantities, "The verdict on each quantity.", state_quantity);
}

// Gravity by every estimator, and where to oscillate next.

void state_cross_checks(Fields& f, const method::selection::CrossChecksResult& result) {
  f.list(
      "gravity", result.checks, "",
      [](Fields& one, const method::selection::CrossCheck& c) {
        one.text("method", to_string(c.estimator),
                 "Estimator: model, midline, AB, CD, EF, fit or sweep.");
        one.flag("recommended", c.is_recommended);
        one.interval("gravity_Nm", c.gravity_Nm, "Motor side, closed form.");
        one.interval("mass_kg", c.mass_kg, "Closed form.");
        one.number("difference_percent", c.difference_percent, "To the recommended one.");
        one.number("difference_half_width_percent", c.difference_half_width_percent,
                   "95 %, of the difference itself.");
        one.number("difference_in_intervals", c.difference_in_intervals,
                   "Above 1 the two disagree.");
        one.flag("disagrees", c.disagrees, "Beyond its interval and beyond 0.1 %.");
      },
      "One estimator.");
}

void state_ripple(Fields& f, const method::gravity::Ripple& ripple) {
  f.list(
      "lines", ripple.lines, "",
      [](Fields& one, const method::gravity::RippleLine& line) {
        one.number("periods_per_turn", line.periods_per_turn);
        one.number("amplitude_Nm", line.amplitude_Nm);
        one.number("phase_rad", line.phase_rad);
      },
      "amplitude cos(periods_per_turn motor angle + phase)");
  f.number("rest_Nm", ripple.rest_Nm,
           "Standard deviation of what is neither line nor white noise.");
  f.number("half_width_Nm", ripple.half_width_Nm(), "95 % of all motor angles lie within.");
}

void state_position_plan(Fields& f, const std::optional<method::hysteresis::PositionPlan>& plan) {
  f.object_or_null(
      "position_plan", plan, "Where to oscillate next, so that ripple averages out.",
      [](Fields& of, const method::hysteresis::PositionPlan& p) {
        of.number("spread_motor_rad", p.spread_motor_rad,
                  "Motor angle over which all positions are spread.");
        of.numbers("further_rad", p.further_rad, "Joint angles.");
        of.number("half_width_now_Nm", p.half_width_now_Nm, "Of the mid-line, motor side.");
        of.number("ripple_half_width_Nm", p.ripple_half_width_Nm, "What of it the ripple demands.");
        of.number("expected_half_width_Nm", p.expected_half_width_Nm,
                  "With all positions recorded.");
      });
}

}  // namespace tribolog::calibration
