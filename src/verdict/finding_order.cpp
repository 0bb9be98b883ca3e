#include "verdict/finding_order.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <variant>

#include "calibration/calibration.h"

namespace tribolog::verdict {

namespace {

/// Whether the statement has one of the codes, or one inside it has.
bool says(const Statement& statement, const std::vector<Code>& codes) {
  if (std::find(codes.begin(), codes.end(), statement.code()) != codes.end()) return true;
  return std::any_of(statement.values().begin(), statement.values().end(), [&](const auto& v) {
    const auto* inside = std::get_if<std::vector<Statement>>(&v.value);
    return inside != nullptr && std::any_of(inside->begin(), inside->end(),
                                            [&](const Statement& one) { return says(one, codes); });
  });
}

/// Whether what one finding states is a consequence of what the other states: loops that disagree
/// with sweeps and runs as an offset makes them, loops that are beside a peak that a moving joint
/// has shifted or that no gravity makes.
bool follows_from(const Statement& finding, const Statement& cause) {
  if (says(finding, {"cross_check.disagree"})) {
    return says(cause, {"effect.offset", "effect.asymmetry"});
  }
  return says(finding, {"check.oscillation_at_peak"}) &&
         says(cause, {"cause.other_joint", "cause.no_gravity", "cause.no_gravity_or_removed"});
}

/// Whether a number's reason is the effect that the finding names.
bool is_of_same_effect(const Statement& reason, const Statement& finding) {
  const bool is_of_effect =
      reason.is("model.rests_on_effect") || reason.is("model.effect_too_large");
  return is_of_effect && finding.is("model.effect_shows") &&
         std::find(finding.values().begin(), finding.values().end(), reason.values().front()) !=
             finding.values().end();
}

/// How many of the numbers that decide rest their doubt on a finding: it is the first reason, or
/// follows from the first.
std::ptrdiff_t numbers_resting_on(const Statement& finding,
                                  const std::vector<calibration::QuantityVerdict>& quantities) {
  return std::count_if(
      quantities.begin(), quantities.end(), [&](const calibration::QuantityVerdict& q) {
        if (!q.decides || q.verdict == calibration::Verdict::usable || q.reasons.empty())
          return false;
        if (q.reasons.front() == finding || is_of_same_effect(q.reasons.front(), finding)) {
          return true;
        }
        return q.reasons.size() > 1 && q.reasons[1] == finding &&
               follows_from(finding, q.reasons.front());
      });
}

/// Each finding stands behind the first that it follows from.
void put_causes_first(std::vector<Statement>& findings) {
  for (auto at = findings.begin(); at != findings.end(); ++at) {
    const auto cause = std::find_if(
        at + 1, findings.end(), [&](const Statement& other) { return follows_from(*at, other); });
    if (cause != findings.end()) std::rotate(at, cause, cause + 1);
  }
}

}  // namespace

void give_causes_as_reasons(const std::vector<calibration::RuleOutcome>& rules,
                            std::vector<calibration::QuantityVerdict>& quantities) {
  for (calibration::QuantityVerdict& q : quantities) {
    for (std::size_t k = 0; k < q.reasons.size(); ++k) {
      const auto cause = std::find_if(rules.begin(), rules.end(), [&](const auto& rule) {
        return !rule.finding.empty() && follows_from(q.reasons[k], rule.finding);
      });
      if (cause == rules.end()) continue;
      if (std::find(q.reasons.begin(), q.reasons.end(), cause->finding) != q.reasons.end())
        continue;
      q.reasons.insert(q.reasons.begin() + static_cast<std::ptrdiff_t>(k), cause->finding);
      ++k;
    }
  }
}

void order_findings(const std::vector<calibration::QuantityVerdict>& quantities, std::size_t checks,
                    std::vector<Statement>& findings) {
  const auto behind_checks = findings.begin() + static_cast<std::ptrdiff_t>(checks);
  std::stable_sort(behind_checks, findings.end(), [&](const Statement& a, const Statement& b) {
    return numbers_resting_on(a, quantities) > numbers_resting_on(b, quantities);
  });
  put_causes_first(findings);
}

}  // namespace tribolog::verdict
