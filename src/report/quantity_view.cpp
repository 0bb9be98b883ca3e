// The verdict on each quantity, as rows of the first table.

#include "report/units.h"
#include "report/view_parts.h"

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

}  // namespace

std::vector<QuantityRow> quantity_rows(const Judgement& judgement) {
  std::vector<QuantityRow> rows;
  for (const QuantityVerdict& q : judgement.quantities) {
    QuantityRow row;
    row.words = q.words;
    row.outcome = outcome_of(q.verdict);
    row.verdict_word = word_of(q.verdict);
    if (q.estimate) row.estimate = in_words(*q.estimate, quantity_scale(q.unit, q.estimate->value));
    for (const std::string& reason : q.reasons) row.reasons.push_back(as_sentence(reason));
    for (const LimitOutcome& limit : q.limits) {
      // A limit that is not kept is among the reasons.
      if (limit.state == LimitState::inside) row.limits.push_back(as_sentence(limit.words));
    }
    row.experiment = as_sentence(q.experiment);
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace tribolog::report
