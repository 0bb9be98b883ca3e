#include "verdict/judge.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include "calibration/calibration.h"
#include "calibration/friction_speeds.h"
#include "calibration/quantity_verdict.h"
#include "method/checks/data_check.h"
#include "verdict/acceptance.h"
#include "verdict/curve_findings.h"
#include "verdict/effect_findings.h"
#include "verdict/finding_order.h"
#include "verdict/headline.h"
#include "verdict/model_verdicts.h"
#include "verdict/needs.h"
#include "verdict/quantity_rooms.h"
#include "verdict/rules.h"
#include "verdict/uncertainty_budget.h"

namespace tribolog::verdict {

namespace {

using joint::Quantity;
using method::checks::CheckName;
using method::hysteresis::Estimator;

// The verdict on a quantity that is not recovered from a simulation of itself.

/// The quantities that a reading of the check stands for.
Quantities quantities_of(calibration::ReadingName reading, std::optional<Estimator> recommended) {
  using calibration::ReadingName;
  switch (reading) {
    case ReadingName::q_peak:
      return {Quantity::cog_angle};
    case ReadingName::bristle_stiffness:
      return {Quantity::bristle_stiffness};
    case ReadingName::static_torque:
      return {Quantity::break_away_torque};
    case ReadingName::coulomb:
      return {Quantity::coulomb_torque};
    case ReadingName::viscous:
      return {Quantity::viscous_coefficient};
    case ReadingName::stribeck_speed:
      return {Quantity::stribeck_speed};
    default:
      break;
  }
  const std::optional<Estimator> estimator = calibration::estimator_of(reading);
  return estimator && estimator == recommended ? of_mass : none;
}

/// Makes doubtful the quantities that the method does not recover.
/// @param recommended estimator of the mass: gravity torque and mass rest on it alone.
void apply_truth_check(const calibration::TruthCheckResult& check,
                       std::optional<Estimator> recommended,
                       std::vector<calibration::QuantityVerdict>& quantities) {
  for (const calibration::TruthFinding& finding : check.findings) {
    for (const Quantity quantity : quantities_of(finding.name, recommended)) {
      calibration::lower(verdict_on(quantity, quantities), calibration::Verdict::doubtful,
                         finding.finding, {"record.better_motion"});
    }
  }
}

/// Off the gravity peak the loops' mean needs the cosine, and with it an angle that can be used.
void doubt_masses_off_the_peak(const calibration::Calibration& c,
                               std::vector<calibration::QuantityVerdict>& all) {
  const method::checks::DataCheck* check = c.data_checks.find(CheckName::oscillation_at_peak);
  if (check == nullptr || check->state != method::checks::CheckState::warns ||
      c.selection.recommended == Estimator::sweep ||
      verdict_on(Quantity::cog_angle, all).verdict == calibration::Verdict::usable) {
    return;
  }
  constexpr double near_deg = 10;  // an angle's error of 1° costs 0.3 % there
  if (*check->measured <= near_deg) return;
  for (const Quantity quantity : of_mass) {
    calibration::lower(
        verdict_on(quantity, all), calibration::Verdict::doubtful,
        {"verdict.check_fails", {{"found", check->found}, {"consequence", check->consequence}}},
        check->experiment);
  }
}

std::vector<calibration::QuantityVerdict> judge_quantities(const calibration::Calibration& c,
                                                           const std::vector<BrokenRule>& broken) {
  std::vector<calibration::QuantityVerdict> all = gravity_verdicts(c);
  for (const auto& room : {bristle_verdicts(c), curve_verdicts(c)}) {
    all.insert(all.end(), room.begin(), room.end());
  }
  for (calibration::QuantityVerdict& one : all) {
    one.unit = joint::unit_of(one.quantity, c.manifest.torque_unit());
  }
  for (const Statement& finding : c.cross_checks.findings) {
    if (!c.cross_checks.doubtful) break;
    for (const Quantity quantity : of_mass) {
      calibration::lower(verdict_on(quantity, all), calibration::Verdict::doubtful, finding,
                         {"record.eight_positions"});
    }
  }
  lower_by_rules(broken, all);
  doubt_masses_off_the_peak(c, all);
  if (c.manifest.torque_is_in_amperes) {
    calibration::QuantityVerdict& q = verdict_on(Quantity::surrogate_mass, all);
    q.estimate.reset();
    calibration::lower(q, calibration::Verdict::not_identifiable, {"effort.constant_unknown"},
                       {"effort.state_constant"});
  }
  apply_truth_check(c.truth_check, c.selection.recommended, all);
  return all;
}

/// The check's title and what it found.
Statement finding_of(const method::checks::DataCheck& check) {
  return {
      "verdict.check",
      {{"check", Statement(Code::of("check." + to_string(check.name)))}, {"found", check.found}}};
}

bool is_of_gravity(const statistics::StageReport& stage) {
  constexpr std::array names{"cog_rough", "cog_precise", "surrogate_masses", "selection"};
  return std::find(names.begin(), names.end(), stage.name) != names.end();
}

/// Most important first: what is wrong with the data; then that on which most numbers rest their
/// doubt, and else disagreements, broken limits, how friction is, what is missing, notes.
std::vector<Statement> collect_findings(const calibration::Calibration& c,
                                        const calibration::Judgement& judgement,
                                        const std::vector<Statement>& disagreements) {
  std::vector<Statement> findings;
  const auto add = [&](const Statement& finding) {
    const bool is_new = std::find(findings.begin(), findings.end(), finding) == findings.end();
    if (!finding.empty() && is_new) findings.push_back(finding);
  };
  for (const method::checks::DataCheck* check :
       c.data_checks.in_state(method::checks::CheckState::fails)) {
    add(finding_of(*check));
  }
  const std::size_t checks = findings.size();
  for (const calibration::RuleOutcome& rule : judgement.rules) {
    if (!rule.is_note) add(rule.finding);
  }
  if (c.position_plan)
    add(method::hysteresis::why_more_positions(*c.position_plan, c.rough.ripple));
  for (const Statement& one : disagreements) add(one);
  for (const calibration::QuantityVerdict& quantity : judgement.quantities) {
    for (const calibration::LimitOutcome& limit : quantity.limits) {
      if (limit.state != calibration::LimitState::inside) add(limit.outcome);
    }
  }
  for (const Statement& one : curve_findings(c)) add(one);
  for (const Statement& one : effect_findings(c)) add(one);
  for (const statistics::StageReport& stage : c.stages()) {
    const bool is_asked_for =
        !(has_stated_no_gravity(c) && is_of_gravity(stage)) &&
        !(has_points_alone(c) && stage.state == statistics::StageState::skipped);
    if (stage.state != statistics::StageState::done && is_asked_for) add(stage.reason);
  }
  for (const calibration::TruthFinding& one : c.truth_check.findings) add(one.finding);
  for (const method::checks::DataCheck* check :
       c.data_checks.in_state(method::checks::CheckState::warns)) {
    add(finding_of(*check));
  }
  for (const calibration::RuleOutcome& rule : judgement.rules) {
    if (rule.is_note) add(rule.finding);
  }
  add(what_is_not_stated(c, judgement.quantities));
  order_findings(judgement.quantities, checks, findings);
  return findings;
}

}  // namespace

calibration::Judgement judge(const calibration::Calibration& c) {
  calibration::Judgement out;
  const std::vector<Statement>& disagreements = c.cross_checks.findings;
  AppliedRules rules = apply_rules(c);
  out.quantities = judge_quantities(c, rules.broken);
  out.rules = std::move(rules.outcomes);
  give_causes_as_reasons(out.rules, out.quantities);
  state_by_model(c, rules.broken, out.quantities);
  doubt_wide_contacts(c, out.quantities);
  std::vector<double> stated = c.manifest.friction_at_rad_s;
  for (double& speed : stated) speed *= std::abs(c.manifest.drive.gear_ratio());
  out.friction_at_speed =
      calibration::with_stated_speeds(friction_at_speeds(c, rules.broken), stated);
  const bool without_gravity = is_without_gravity(rules.broken);
  if (without_gravity) {
    // Identifying friction alone is legitimate: nothing is missing.
    for (const Quantity quantity : of_gravity) {
      calibration::QuantityVerdict& q = verdict_on(quantity, out.quantities);
      q.decides = false;
      if (!has_stated_no_gravity(c)) continue;
      q.estimate.reset();
      q.reasons = {why_no_gravity(c)};
      q.experiment = {};
    }
  }
  // No mass follows from amperes.
  if (c.manifest.torque_is_in_amperes) {
    verdict_on(Quantity::surrogate_mass, out.quantities).decides = false;
  }
  if (has_points_alone(c)) {
    for (const Quantity quantity : {Quantity::break_away_torque, Quantity::bristle_stiffness}) {
      verdict_on(quantity, out.quantities).decides = false;
    }
  }
  lower_verdicts_by_influences(c, out.quantities);
  state_budgets(c, out.quantities);
  doubt_wide_intervals(out.quantities);
  apply_limits(c.manifest.limits, c.manifest.drive.gear_ratio(), out.quantities);
  const auto is_known = [&](Quantity quantity) {
    return verdict_on(quantity, out.quantities).verdict != calibration::Verdict::not_identifiable;
  };
  const bool has_angle = is_known(Quantity::cog_angle);
  const bool has_mass = is_known(Quantity::gravity_torque) &&
                        (is_known(Quantity::surrogate_mass) || c.manifest.torque_is_in_amperes);
  out.verdict = calibration::Verdict::usable;
  for (const calibration::QuantityVerdict& quantity : out.quantities) {
    if (quantity.decides && quantity.verdict != calibration::Verdict::usable)
      out.verdict = calibration::Verdict::doubtful;
  }
  if ((!has_angle || !has_mass) && !without_gravity)
    out.verdict = calibration::Verdict::not_identifiable;
  out.sentence = headline(c, out, without_gravity);
  out.findings = collect_findings(c, out, disagreements);
  return out;
}

calibration::QuantityVerdict& verdict_on(joint::Quantity quantity,
                                         std::vector<calibration::QuantityVerdict>& all) {
  const auto it = std::find_if(all.begin(), all.end(), [&](const calibration::QuantityVerdict& q) {
    return q.quantity == quantity;
  });
  if (it == all.end()) throw std::logic_error("missing verdict: " + to_string(quantity));
  return *it;
}

calibration::QuantityVerdict by_estimate(joint::Quantity quantity,
                                         const std::optional<statistics::Estimate>& estimate,
                                         const Statement& why_absent, const Statement& experiment) {
  calibration::QuantityVerdict q;
  q.quantity = quantity;
  if (!estimate || !std::isfinite(estimate->value)) {
    calibration::lower(q, calibration::Verdict::not_identifiable, why_absent, experiment);
    return q;
  }
  q.estimate = estimate;
  const double share = estimate->half_width() / std::abs(estimate->value);
  if (!(estimate->low > 0)) {
    calibration::lower(q, calibration::Verdict::not_identifiable,
                       estimate->low < 0 ? Statement{"verdict.interval_reaches_below_zero"}
                                         : Statement{"verdict.interval_reaches_zero"},
                       experiment);
  } else if (!(share <= widest_with_stated(quantity))) {
    constexpr double order_of_magnitude = 10;
    calibration::lower(q, calibration::Verdict::doubtful,
                       share > order_of_magnitude
                           ? Statement{"verdict.size_not_known"}
                           : Statement{"verdict.known_to_share", {{"percent", 100 * share}}},
                       experiment);
  }
  return q;
}

}  // namespace tribolog::verdict
