#include "verdict/rules.h"

#include <algorithm>
#include <string_view>

#include "verdict/quantity_rooms.h"

namespace tribolog::verdict {
namespace {

using calibration::Calibration;
using calibration::RuleState;
using calibration::Verdict;

std::optional<BrokenRule> broken_by_check(const Rule& rule, const Calibration& c) {
  const auto* check = c.data_checks.find(std::get<method::checks::CheckName>(rule.by));
  if (check == nullptr || check->state != method::checks::CheckState::fails) return std::nullopt;
  return BrokenRule{
      &rule,
      {"verdict.check_fails", {{"found", check->found}, {"consequence", check->consequence}}},
      check->experiment};
}

calibration::RuleOutcome outcome_of(const Rule& rule, const RuleNumber& number,
                                    const Calibration& c) {
  calibration::RuleOutcome o;
  o.rule = number.name;
  o.threshold = number.threshold;
  o.unit = number.unit;
  o.quantities = rule.quantities;
  o.lowers_to = rule.lowers_to;
  o.is_note = number.is_note;
  if (const std::optional<Measured> found = number.measure(c)) {
    o.value = found->value;
    o.state = found->value > number.threshold ? RuleState::broken : RuleState::kept;
    if (o.state == RuleState::broken) o.finding = found->finding;
  }
  return o;
}

}  // namespace

const std::vector<Rule>& rules() {
  static const std::vector<Rule> all = [] {
    std::vector<Rule> every;
    for (const auto& part : {check_rules(), gravity_rules(), friction_rules()}) {
      every.insert(every.end(), part.begin(), part.end());
    }
    return every;
  }();
  return all;
}

AppliedRules apply_rules(const Calibration& c) {
  AppliedRules out;
  for (const Rule& rule : rules()) {
    if (rule.applies != nullptr && !rule.applies(c)) continue;
    const RuleNumber* number = rule.number();
    if (number == nullptr) {
      if (const auto broken = broken_by_check(rule, c)) out.broken.push_back(*broken);
      continue;
    }
    out.outcomes.push_back(outcome_of(rule, *number, c));
    const calibration::RuleOutcome& o = out.outcomes.back();
    if (o.state == RuleState::broken) out.broken.push_back({&rule, o.finding, rule.experiment});
  }
  return out;
}

void lower_by_rules(const std::vector<BrokenRule>& broken,
                    std::vector<calibration::QuantityVerdict>& quantities) {
  for (const BrokenRule& one : broken) {
    if (one.rule->lowers_to == Verdict::usable) continue;
    for (const joint::Quantity touched : one.rule->quantities) {
      calibration::lower(verdict_on(touched, quantities), one.rule->lowers_to, one.reason,
                         one.experiment);
    }
  }
}

bool is_without_gravity(const std::vector<BrokenRule>& broken) {
  return std::any_of(broken.begin(), broken.end(), [](const BrokenRule& one) {
    const RuleNumber* number = one.rule->number();
    return number != nullptr && std::string_view(number->name) == "friction_over_gravity";
  });
}

}  // namespace tribolog::verdict
