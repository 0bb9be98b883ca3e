// The verdict on each quantity, as rows of the first table.

#include <algorithm>

#include "report/view_parts.h"
#include "wording/units.h"

namespace tribolog::report {
namespace {

Outcome outcome_of(Verdict verdict) {
  return verdict == Verdict::usable     ? Outcome::good
         : verdict == Verdict::doubtful ? Outcome::partial
                                        : Outcome::bad;
}

std::string word_of(Verdict verdict) {
  return verdict == Verdict::not_identifiable ? "not identifiable" : to_string(verdict);
}

/// "≤ 12 N·m", of a half width "± ≤ 5 %".
std::string rule_of(const LimitOutcome& limit) {
  const bool is_of_width = limit.rule.starts_with("half_width");
  const bool is_percent = limit.rule == "half_width_percent";
  const char* const sign = limit.rule == "min" ? "≥ " : is_of_width ? "± ≤ " : "≤ ";
  const bool at_joint = limit.key.find("_joint") != std::string::npos;
  return sign + with_unit(as_stated(limit.limit), is_percent ? "%" : limit.unit) +
         (at_joint ? " at the joint" : "");
}

LimitCell cell_of(const LimitOutcome& limit) {
  switch (limit.state) {
    case LimitState::inside:
      return {rule_of(limit), "kept", Outcome::good};
    case LimitState::outside:
      return {rule_of(limit), "broken", Outcome::bad};
    case LimitState::crosses:
      return {rule_of(limit), "not shown to be kept", Outcome::partial};
    case LimitState::unknown:
      break;
  }
  return {rule_of(limit), "not known", Outcome::absent};
}

void add_estimate(const QuantityVerdict& q, QuantityRow& row) {
  if (!q.estimate) return;
  const Scale scale = quantity_scale(q.unit, q.estimate->value);
  const RoundedEstimate text = round_by_interval(*q.estimate, scale);
  row.estimate = with_unit(text.estimate, scale.unit);
  // Narrower than what is printed of the estimate.
  row.interval =
      text.low.empty() && !text.half_width.empty() ? "± " + text.half_width : text.range();
}

void add_change(const history::Comparison& since_last, const QuantityVerdict& q, QuantityRow& row) {
  const auto found =
      std::find_if(since_last.quantities.begin(), since_last.quantities.end(),
                   [&](const history::ComparedQuantity& c) { return c.name == q.key; });
  if (found == since_last.quantities.end()) return;
  row.change_word = history::to_string(found->word);
  row.is_changed = found->word == history::ChangeWord::changed;
  const history::ComparedQuantity& compared = *found;
  if (!compared.change) return;
  const Estimate& absolute = compared.change->absolute;
  const Scale scale =
      quantity_scale(compared.unit, compared.second ? compared.second->value : absolute.value);
  const RoundedEstimate text = round_by_interval(absolute, scale);
  row.change = with_unit(with_plus_sign(text.estimate), scale.unit);
  row.change_range = text.half_width.empty() ? text.range() : "± " + text.half_width;
}

}  // namespace

std::vector<QuantityRow> quantity_rows(const Judgement& judgement,
                                       const std::optional<history::Comparison>& since_last) {
  const auto& findings = judgement.findings;
  const auto end_in_sight =
      findings.begin() + static_cast<std::ptrdiff_t>(std::min(findings.size(), findings_in_sight));
  // A limit's words stand once on the first screen; its row has the rule and what came of it.
  const auto stands_above = [&](const QuantityVerdict& q, const std::string& reason) {
    return std::any_of(q.limits.begin(), q.limits.end(),
                       [&](const LimitOutcome& limit) { return limit.words == reason; }) &&
           std::find(findings.begin(), end_in_sight, reason) != end_in_sight;
  };
  std::vector<QuantityRow> rows;
  for (const QuantityVerdict& q : judgement.quantities) {
    QuantityRow row;
    row.words = q.words;
    row.outcome = outcome_of(q.verdict);
    row.verdict_word = word_of(q.verdict);
    add_estimate(q, row);
    for (const LimitOutcome& limit : q.limits) row.limits.push_back(cell_of(limit));
    if (since_last) add_change(*since_last, q, row);
    for (const std::string& reason : q.reasons) {
      if (!stands_above(q, reason)) row.reasons.push_back(as_sentence(reason));
    }
    row.experiment = as_sentence(q.experiment);
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace tribolog::report
