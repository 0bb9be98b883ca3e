#include "report/document/findings_view.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <variant>

#include "report/document/view_parts.h"
#include "wording/tr.h"
#include "wording/words.h"

namespace tribolog::report::document {

using wording::tr;

namespace {

/// The statements that stand inside another, by name; nullptr: there are none.
const std::vector<Statement>* inside(const Statement& statement, std::string_view name) {
  for (const StatedValue& value : statement.values()) {
    if (value.name == name) return std::get_if<std::vector<Statement>>(&value.value);
  }
  return nullptr;
}

bool holds(const Statement& statement, const Statement& part) {
  return std::any_of(
      statement.values().begin(), statement.values().end(), [&](const StatedValue& value) {
        const auto* parts = std::get_if<std::vector<Statement>>(&value.value);
        return parts != nullptr && std::any_of(parts->begin(), parts->end(), [&](const auto& one) {
                 return one == part || holds(one, part);
               });
      });
}

/// Whether the finding says what the reason rests on: the same, what the same check found, or what
/// stands inside the reason ("nothing independent checks it: ...").
bool explains(const Statement& finding, const Statement& reason) {
  if (finding == reason || holds(reason, finding)) return true;
  const auto* found = inside(finding, "found");
  const auto* of_reason = inside(reason, "found");
  return finding.is("verdict.check") && found != nullptr && of_reason != nullptr &&
         *found == *of_reason;
}

/// Whether a quantity's verdict rests on it.
bool is_reason(const Statement& finding, const calibration::QuantityVerdict& q) {
  return std::any_of(q.reasons.begin(), q.reasons.end(),
                     [&](const Statement& reason) { return explains(finding, reason); });
}

/// Reasons that are no findings of their own say how little is known of a quantity. Before these
/// stands what the rules found the farthest beyond its threshold: it may well be why.
void move_cause_to_front(const calibration::Judgement& judgement,
                         std::vector<Statement>& statements) {
  const std::vector<Statement>& findings = judgement.findings;
  if (statements.empty() ||
      std::find(findings.begin(), findings.end(), statements.front()) != findings.end()) {
    return;
  }
  double farthest = 0;
  auto cause = statements.end();
  for (const calibration::RuleOutcome& rule : judgement.rules) {
    if (rule.is_note || rule.finding.empty() || !rule.value) continue;
    const double times = *rule.value / rule.threshold;
    const auto at = std::find(statements.begin(), statements.end(), rule.finding);
    if (at == statements.end() || !(times > farthest)) continue;
    farthest = times;
    cause = at;
  }
  if (cause != statements.end()) std::rotate(statements.begin(), cause, cause + 1);
}

}  // namespace

NumberedFindings::NumberedFindings(const calibration::Judgement& judgement) {
  statements_ = judgement.findings;
  for (const calibration::QuantityVerdict& q : judgement.quantities) {
    for (const Statement& reason : q.reasons) {
      if (number_of(reason) == 0) statements_.push_back(reason);
    }
  }
  const auto weight = [&](const Statement& statement) {
    int heaviest = 2;
    for (const calibration::QuantityVerdict& q : judgement.quantities) {
      if (is_reason(statement, q)) heaviest = std::min(heaviest, is_merely_absent(q) ? 1 : 0);
    }
    return heaviest;
  };
  std::stable_sort(statements_.begin(), statements_.end(),
                   [&](const Statement& a, const Statement& b) { return weight(a) < weight(b); });
  move_cause_to_front(judgement, statements_);
  for (const Statement& statement : statements_) {
    Finding finding;
    finding.number = static_cast<int>(findings_.size()) + 1;
    finding.text = wording::as_sentence(statement);
    findings_.push_back(std::move(finding));
  }
  for (const calibration::QuantityVerdict& q : judgement.quantities) {
    const std::string name = name_within_a_sentence(q.quantity);
    for (const int number : numbers_of(q)) {
      findings_[static_cast<std::size_t>(number) - 1].quantities.push_back(name);
    }
    for (const Statement& reason : q.reasons) {
      const auto* consequence = inside(reason, "consequence");
      if (consequence == nullptr || consequence->empty()) continue;
      findings_[static_cast<std::size_t>(number_of(reason)) - 1].consequence =
          wording::as_sentence(consequence->front());
    }
  }
  for (Finding& finding : findings_) finding.is_note = finding.quantities.empty();
  put_nouns_first(judgement);
}

void NumberedFindings::put_nouns_first(const calibration::Judgement& judgement) {
  for (std::size_t k = 0; k < statements_.size(); ++k) {
    const bool is_of_its_own = std::find(judgement.findings.begin(), judgement.findings.end(),
                                         statements_[k]) == judgement.findings.end();
    Finding& finding = findings_[k];
    if (!is_of_its_own || finding.quantities.size() != 1) continue;
    finding.text = wording::as_sentence(tr(
        "{quantity}: {finding}",
        {{"quantity", finding.quantities.front()}, {"finding", wording::words(statements_[k])}}));
    finding.quantities.clear();
  }
}

int NumberedFindings::number_of(const Statement& statement) const {
  // The same words before those that it merely rests on.
  const auto same = std::find(statements_.begin(), statements_.end(), statement);
  const auto found = same != statements_.end()
                         ? same
                         : std::find_if(statements_.begin(), statements_.end(),
                                        [&](const auto& one) { return explains(one, statement); });
  return found == statements_.end() ? 0 : static_cast<int>(found - statements_.begin()) + 1;
}

std::vector<int> NumberedFindings::numbers_of(const calibration::QuantityVerdict& q) const {
  std::vector<int> numbers;
  for (const Statement& reason : q.reasons) {
    const int number = number_of(reason);
    if (number > 0) numbers.push_back(number);
  }
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  return numbers;
}

std::vector<NextStep> next_steps(const calibration::Calibration& c) {
  std::vector<NextStep> steps;
  const auto step_of = [&](const Statement& experiment) {
    const std::string text = wording::as_sentence(experiment);
    const auto found = std::find_if(steps.begin(), steps.end(),
                                    [&](const NextStep& one) { return one.text == text; });
    return found != steps.end() ? found : steps.insert(steps.end(), {text, {}});
  };
  const auto add = [](const calibration::QuantityVerdict& q, NextStep& step) {
    const std::string name = name_within_a_sentence(q.quantity);
    if (std::find(step.quantities.begin(), step.quantities.end(), name) == step.quantities.end()) {
      step.quantities.push_back(name);
    }
  };
  for (const method::checks::DataCheck* check :
       c.data_checks.in_state(method::checks::CheckState::fails)) {
    if (check->experiment.empty()) continue;
    for (const calibration::QuantityVerdict& q : c.judgement.quantities) {
      const bool is_touched =
          std::any_of(q.reasons.begin(), q.reasons.end(), [&](const Statement& reason) {
            const auto* found = inside(reason, "found");
            return found != nullptr && found->size() == 1 && found->front() == check->found;
          });
      if (is_touched) add(q, *step_of(check->experiment));
    }
  }
  const auto of_checks = static_cast<std::ptrdiff_t>(steps.size());
  for (const calibration::QuantityVerdict& q : c.judgement.quantities) {
    if (!q.experiment.empty()) add(q, *step_of(q.experiment));
  }
  std::stable_sort(steps.begin() + of_checks, steps.end(),
                   [](const NextStep& a, const NextStep& b) {
                     return a.quantities.size() > b.quantities.size();
                   });
  return steps;
}

}  // namespace tribolog::report::document
