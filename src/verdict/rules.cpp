#include "verdict/rules.h"

#include <algorithm>

#include "method/hysteresis/lugre_fit.h"

namespace tribolog::verdict {
namespace {

using calibration::Calibration;
using calibration::Verdict;
using joint::Quantity;

/// A number of a model is one of the joint as far as the model describes the joint: what LuGre
/// leaves of the loop that it describes worst, as a share of that loop's height.
std::optional<Measured> loop_misfit(const Calibration& c) {
  if (!c.lugre || !c.lugre->converged) return std::nullopt;
  const method::hysteresis::LuGreLoop* worst = c.lugre->worst_described();
  if (worst == nullptr || !(worst->height_Nm > 0)) return std::nullopt;
  const double percent = 100 * worst->systematic_Nm / worst->height_Nm;
  return Measured{percent,
                  {"cause.other_contact",
                   {{"recording", worst->recording},
                    {"misfit_Nm", worst->systematic_Nm},
                    {"percent", percent}}}};
}

}  // namespace

const std::vector<Rule>& rules() {
  static const std::vector<Rule> all{
      // A joint whose loop differs from LuGre's by 0.6 % of its height can be 26 % stiffer or
      // softer (tests/identify/other_friction_test.cpp).
      {"loop_misfit",
       "%",
       0.5,
       Verdict::doubtful,
       {Quantity::bristle_stiffness, Quantity::bristle_damping},
       "record.compare_reversals",
       loop_misfit},
      {"loop_unlike_model",
       "%",
       10,
       Verdict::not_identifiable,
       {Quantity::bristle_stiffness, Quantity::bristle_damping},
       "record.compare_reversals",
       loop_misfit},
  };
  return all;
}

std::vector<calibration::RuleOutcome> apply_rules(
    const Calibration& c, std::vector<calibration::QuantityVerdict>& quantities) {
  std::vector<calibration::RuleOutcome> outcomes;
  for (const Rule& rule : rules()) {
    calibration::RuleOutcome o{rule.name,
                               calibration::RuleState::not_computed,
                               {},
                               rule.threshold,
                               rule.unit,
                               rule.quantities,
                               rule.lowers_to,
                               {}};
    if (const std::optional<Measured> found = rule.measure(c)) {
      o.value = found->value;
      o.state = found->value > rule.threshold ? calibration::RuleState::broken
                                              : calibration::RuleState::kept;
      if (o.state == calibration::RuleState::broken) o.finding = found->finding;
    }
    for (calibration::QuantityVerdict& q : quantities) {
      if (o.state != calibration::RuleState::broken) break;
      const bool is_touched = std::find(rule.quantities.begin(), rule.quantities.end(),
                                        q.quantity) != rule.quantities.end();
      if (is_touched) calibration::lower(q, rule.lowers_to, o.finding, rule.experiment);
    }
    outcomes.push_back(std::move(o));
  }
  return outcomes;
}

}  // namespace tribolog::verdict
