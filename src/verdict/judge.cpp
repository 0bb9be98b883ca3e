#include "verdict/judge.h"

#include <algorithm>

#include "verdict/acceptance.h"
#include "verdict/check_consequences.h"
#include "verdict/curve_findings.h"
#include "verdict/quantity_rooms.h"
#include "verdict/truth_consequences.h"

namespace tribolog {
namespace {

std::vector<QuantityVerdict> judge_quantities(const Calibration& c) {
  std::vector<QuantityVerdict> all = gravity_verdicts(c);
  for (const auto& room : {bristle_verdicts(c), curve_verdicts(c)}) {
    all.insert(all.end(), room.begin(), room.end());
  }
  for (const std::string& words : c.cross_checks.findings) {
    if (!c.cross_checks.doubtful) break;
    for (std::size_t k = 1; k < 3; ++k) {
      lower(all[k], Verdict::doubtful, words,
            "the micro-oscillation at eight positions spread over one turn of the motor");
    }
  }
  const Sources sources{!c.viscous.runs.empty() && !c.viscous.from_sweep,
                        c.selection.recommended == "sweep", c.break_away.mean_Nm.has_value()};
  apply_data_checks(c.data_checks, sources, all);
  apply_truth_check(c.truth_check, c.selection.recommended, all);
  apply_limits(c.manifest.limits, c.manifest.drive.gear_ratio(), all);
  return all;
}

/// Most important first: what is wrong with the data, what does not agree, broken limits, what is
/// missing, what is to be noted.
std::vector<std::string> collect_findings(const Calibration& c, const Judgement& judgement,
                                          const std::vector<std::string>& disagreements) {
  std::vector<std::string> findings;
  const auto add = [&](const std::string& finding) {
    const bool is_new = std::find(findings.begin(), findings.end(), finding) == findings.end();
    if (!finding.empty() && is_new) findings.push_back(finding);
  };
  for (const DataCheck* check : c.data_checks.in_state(CheckState::fails)) {
    add(check->title + ": " + check->found);
  }
  if (c.position_plan) add(ripple_in_words(*c.position_plan, c.rough.ripple));
  for (const std::string& words : disagreements) add(words);
  for (const QuantityVerdict& quantity : judgement.quantities) {
    for (const LimitOutcome& limit : quantity.limits) {
      if (limit.state != LimitState::inside) add(limit.words);
    }
  }
  for (const StageReport& stage : c.stages()) {
    if (stage.state != StageState::done) add(stage.reason);
  }
  for (const std::string& words : curve_findings(c)) add(words);
  for (const TruthFinding& finding : c.truth_check.findings) add(finding.words);
  for (const DataCheck* check : c.data_checks.in_state(CheckState::warns)) {
    add(check->title + ": " + check->found);
  }
  return findings;
}

std::string sentence_of(const Calibration& c, Verdict overall, bool has_angle, bool has_mass,
                        bool has_disagreement, bool limit_broken) {
  const auto failing = c.data_checks.in_state(CheckState::fails);
  if (c.manifest.drive.kind() == EffortKind::none) {
    return "No torque was recorded: the motion alone shows neither gravity nor friction.";
  }
  if (overall == Verdict::not_identifiable) {
    if (!failing.empty() && c.q_peak_rad && !c.selection.recommended.empty()) {
      return "The data cannot carry an identification: " + failing.front()->found + ".";
    }
    return !has_angle && !has_mass
               ? "Neither the centre of gravity nor the surrogate mass can be found in these "
                 "recordings."
           : has_angle ? "The surrogate mass cannot be found in these recordings."
                       : "The angle of the centre of gravity cannot be found in these recordings.";
  }
  if (overall == Verdict::usable) {
    return "All stages have their data, and the independent estimates of the mass agree.";
  }
  if (!failing.empty()) {
    return "Angle and mass are known, but checks on the data fail.";
  }
  if (has_disagreement) return "Angle and mass are known, but independent estimates disagree.";
  if (limit_broken) return "Angle and mass are known, but a limit of the manifest is not kept.";
  if (!c.truth_check.findings.empty()) {
    return "Angle and mass are known, but simulated with what was identified, the method does not "
           "find its own answer.";
  }
  return "Angle and mass are known, but not every stage had the data it needs.";
}

}  // namespace

Judgement judge(const Calibration& c) {
  Judgement out;
  const std::vector<std::string>& disagreements = c.cross_checks.findings;
  out.quantities = judge_quantities(c);
  const auto is_known = [&](std::size_t k) {
    return out.quantities[k].verdict != Verdict::not_identifiable;
  };
  const bool has_angle = is_known(0);
  const bool has_mass = is_known(1) && is_known(2);
  bool limit_broken = false;
  out.verdict = Verdict::usable;
  for (const QuantityVerdict& quantity : out.quantities) {
    if (quantity.decides && quantity.verdict != Verdict::usable) out.verdict = Verdict::doubtful;
    for (const LimitOutcome& limit : quantity.limits) {
      limit_broken |= limit.state != LimitState::inside;
    }
  }
  if (!has_angle || !has_mass) out.verdict = Verdict::not_identifiable;
  out.sentence =
      sentence_of(c, out.verdict, has_angle, has_mass, c.cross_checks.doubtful, limit_broken);
  out.findings = collect_findings(c, out, disagreements);
  return out;
}

}  // namespace tribolog
