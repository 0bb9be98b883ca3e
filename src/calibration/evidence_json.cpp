// What stands behind the numbers: checks on the data before any fit, the verdict, and intervals.

#include <cmath>
#include <utility>

#include "calibration/parts.h"
#include "wording/torques_in.h"
#include "wording/words.h"

namespace tribolog::calibration {

Json data_checks(const method::checks::DataChecksResult& result) {
  Json list = Json::array();
  for (const method::checks::DataCheck& check : result.checks) {
    const std::string name = to_string(check.name);
    list.push_back(
        {{"name", name},
         {"title", wording::words_for("check", name)},
         {"state", method::checks::to_string(check.state)},
         {"recording", text_or_null(check.recording + (check.is_of_whole_role ? ", all" : ""))},
         {"measure", words_or_null(check.measure)},
         {"measure_code", code_of(check.measure)},
         {"measured", number(check.measured)},
         {"at_least", number(check.at_least)},
         {"at_most", number(check.at_most)},
         {"unit", unit_or_null(check.unit)},
         {"found", words_or_null(check.found)},
         {"found_code", code_of(check.found)},
         {"consequence", words_or_null(check.consequence)},
         {"consequence_code", code_of(check.consequence)},
         {"experiment", words_or_null(check.experiment)},
         {"experiment_code", code_of(check.experiment)}});
  }
  return list;
}

// The known-truth check.

namespace {

Json returned(const ReturnedQuantity& q) {
  return {{"name", to_string(q.name)},
          {"unit", wording::shown_units(q.unit)},
          {"put_in", number(q.put_in)},
          {"came_back", number(q.came_back)},
          {"scatter", number(q.scatter)},
          {"half_width", number(q.half_width)},
          {"found", q.found},
          {"inside", q.inside},
          {"in_half_widths", numbers(q.in_half_widths)},
          {"comes_back", q.comes_back}};
}

}  // namespace

Json truth_check(const TruthCheckResult& t) {
  if (t.runs == 0) return nullptr;
  Json quantities = Json::array();
  for (const ReturnedQuantity& q : t.quantities) quantities.push_back(returned(q));
  std::vector<Statement> findings;
  for (const TruthFinding& one : t.findings) findings.push_back(one.finding);
  return {{"runs", t.runs},
          {"seed", t.seed},
          {"noise",
           {{"white_Nm", number(t.white_Nm)},
            {"torque_step_Nm", number(t.torque_step_Nm)},
            {"ripple_Nm", number(t.ripple_Nm)}}},
          {"quantities", std::move(quantities)},
          {"left_out", wording::words(t.left_out)},
          {"left_out_code", code_of(t.left_out)},
          {"findings", wording::words(findings)},
          {"findings_code", code_of(findings)}};
}

// The verdict: overall, on each quantity, and against the manifest's limits.

namespace {

Json limits(const std::vector<LimitOutcome>& outcomes) {
  Json list = Json::array();
  for (const LimitOutcome& o : outcomes) {
    list.push_back({{"quantity", o.key},
                    {"rule", to_string(o.rule)},
                    {"limit", number(o.limit)},
                    {"unit", o.unit},
                    {"estimate", interval(o.estimate)},
                    {"state", to_string(o.state)},
                    {"words", wording::words(o.outcome)},
                    {"words_code", code_of(o.outcome)}});
  }
  return list;
}

}  // namespace

namespace {

Json rules(const std::vector<RuleOutcome>& outcomes) {
  Json all = Json::array();
  for (const RuleOutcome& o : outcomes) {
    Json quantities = Json::array();
    for (const joint::Quantity quantity : o.quantities) quantities.push_back(to_string(quantity));
    all.push_back({{"rule", o.rule},
                   {"words", wording::words_for("rule", o.rule)},
                   {"state", to_string(o.state)},
                   {"value", o.value ? number(*o.value) : Json(nullptr)},
                   {"threshold", number(o.threshold)},
                   {"unit", unit_or_null(o.unit)},
                   {"quantities", std::move(quantities)},
                   {"lowers_to", to_string(o.lowers_to)},
                   {"finding", words_or_null(o.finding)},
                   {"finding_code", code_of(o.finding)}});
  }
  return all;
}

/// null: infinite.
Json freedom(double degrees) { return std::isinf(degrees) ? Json(nullptr) : number(degrees); }

Json budget(const std::optional<UncertaintyBudget>& b) {
  if (!b) return nullptr;
  Json parts = Json::array();
  for (const BudgetPart& part : b->parts) {
    parts.push_back({{"influence", to_string(part.influence)},
                     {"type", part.is_type_b ? "B" : "A"},
                     {"id", part.is_type_b ? Json(part.id) : Json(nullptr)},
                     {"stated", number(part.stated)},
                     {"sensitivity", number(part.sensitivity)},
                     {"standard_uncertainty", number(part.standard_uncertainty)},
                     {"degrees_of_freedom", freedom(part.freedom)},
                     {"share", number(part.share)}});
  }
  Json not_stated = Json::array();
  for (const Influence influence : b->not_stated) not_stated.push_back(to_string(influence));
  Json effects = Json::array();
  for (const BudgetEffect& one : b->effects) {
    effects.push_back({{"effect", one.effect},
                       {"share", number(one.share)},
                       {"size", one.unit.empty() ? Json(nullptr) : number(one.size)},
                       {"unit", unit_or_null(one.unit)},
                       {"is_stated", one.is_stated}});
  }
  return {{"parts", std::move(parts)},
          {"effects", std::move(effects)},
          {"not_included", std::move(not_stated)},
          {"standard_uncertainty", number(b->standard_uncertainty)},
          {"degrees_of_freedom", freedom(b->freedom)},
          {"coverage_factor", number(b->coverage_factor)},
          {"expanded", interval(b->expanded)}};
}

}  // namespace

Json verdict(const Judgement& judgement) {
  Json quantities = Json::array();
  for (const QuantityVerdict& q : judgement.quantities) {
    const std::string key = to_string(q.quantity);
    quantities.push_back({{"key", key},
                          {"words", wording::words_for("quantity", key)},
                          {"verdict", to_string(q.verdict)},
                          {"decides", q.decides},
                          {"reasons", wording::words(q.reasons)},
                          {"reasons_code", code_of(q.reasons)},
                          {"experiment", words_or_null(q.experiment)},
                          {"experiment_code", code_of(q.experiment)},
                          {"estimate", interval(q.estimate)},
                          {"unit", unit_or_null(q.unit)},
                          {"budget", budget(q.budget)},
                          {"limits", limits(q.limits)}});
  }
  return {{"verdict", to_string(judgement.verdict)},
          {"sentence", wording::words(judgement.sentence)},
          {"sentence_code", code_of(judgement.sentence)},
          {"findings", wording::words(judgement.findings)},
          {"findings_code", code_of(judgement.findings)},
          {"rules", rules(judgement.rules)},
          {"quantities", std::move(quantities)}};
}

// Gravity by every estimator, and where to oscillate next.

Json cross_checks(const method::selection::CrossChecksResult& result) {
  Json checks = Json::array();
  for (const method::selection::CrossCheck& c : result.checks) {
    checks.push_back({{"method", to_string(c.estimator)},
                      {"recommended", c.is_recommended},
                      {"gravity_Nm", interval(c.gravity_Nm)},
                      {"mass_kg", interval(c.mass_kg)},
                      {"difference_percent", number(c.difference_percent)},
                      {"difference_half_width_percent", number(c.difference_half_width_percent)},
                      {"difference_in_intervals", number(c.difference_in_intervals)},
                      {"disagrees", c.disagrees}});
  }
  return {{"gravity", std::move(checks)}};
}

Json ripple(const method::gravity::Ripple& ripple) {
  Json lines = Json::array();
  for (const method::gravity::RippleLine& line : ripple.lines) {
    lines.push_back({{"periods_per_turn", number(line.periods_per_turn)},
                     {"amplitude_Nm", number(line.amplitude_Nm)},
                     {"phase_rad", number(line.phase_rad)}});
  }
  return {{"lines", std::move(lines)},
          {"rest_Nm", number(ripple.rest_Nm)},
          {"half_width_Nm", number(ripple.half_width_Nm())}};
}

Json position_plan(const std::optional<method::hysteresis::PositionPlan>& plan) {
  if (!plan) return nullptr;
  return {{"spread_motor_rad", number(plan->spread_motor_rad)},
          {"further_rad", numbers(plan->further_rad)},
          {"half_width_now_Nm", number(plan->half_width_now_Nm)},
          {"ripple_half_width_Nm", number(plan->ripple_half_width_Nm)},
          {"expected_half_width_Nm", number(plan->expected_half_width_Nm)}};
}

}  // namespace tribolog::calibration
