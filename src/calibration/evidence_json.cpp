// Checks on the data before any fit.

#include <utility>

#include "calibration/parts.h"
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
         {"unit", text_or_null(check.unit)},
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
          {"unit", q.unit},
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

// The verdict over all, on each quantity, and against the manifest's limits.

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
                          {"unit", text_or_null(q.unit)},
                          {"limits", limits(q.limits)}});
  }
  return {{"verdict", to_string(judgement.verdict)},
          {"sentence", wording::words(judgement.sentence)},
          {"sentence_code", code_of(judgement.sentence)},
          {"findings", wording::words(judgement.findings)},
          {"findings_code", code_of(judgement.findings)},
          {"quantities", std::move(quantities)}};
}

}  // namespace tribolog::calibration
