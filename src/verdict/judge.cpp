#include "verdict/judge.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "calibration/calibration.h"
#include "calibration/quantity_verdict.h"
#include "method/checks/data_check.h"
#include "verdict/acceptance.h"
#include "verdict/curve_findings.h"
#include "verdict/quantity_rooms.h"

namespace tribolog::verdict {

// What a quantity that does not come back from its own simulation means for the verdict on it.

namespace {

/// Keys of the quantities that a reading of the check stands for.
std::vector<std::string> quantities_of(const std::string& reading, const std::string& recommended) {
  static const std::map<std::string, std::string> keys{
      {"q_peak", "cog_angle"},
      {"bristle_stiffness", "bristle_stiffness"},
      {"static_torque", "break_away_torque"},
      {"coulomb", "coulomb_torque"},
      {"viscous", "viscous_coefficient"},
      {"stribeck_speed", "stribeck_speed"},
  };
  if (reading == recommended) return {"gravity_torque", "surrogate_mass"};
  const auto it = keys.find(reading);
  return it == keys.end() ? std::vector<std::string>{} : std::vector<std::string>{it->second};
}

/// Makes the quantities doubtful that the method cannot find again.
/// @param recommended estimator of the mass: gravity torque and mass stand on it alone.
void apply_truth_check(const calibration::TruthCheckResult& check, const std::string& recommended,
                       std::vector<calibration::QuantityVerdict>& quantities) {
  for (const calibration::TruthFinding& finding : check.findings) {
    for (const std::string& key : quantities_of(finding.name, recommended)) {
      const auto it =
          std::find_if(quantities.begin(), quantities.end(),
                       [&](const calibration::QuantityVerdict& q) { return q.key == key; });
      if (it == quantities.end()) continue;
      calibration::lower(*it, calibration::Verdict::doubtful, finding.finding,
                         {"record.better_motion"});
    }
  }
}

}  // namespace

// What a failing check on the data does to each quantity.

namespace {

/// Which recordings the quantities come from: a failing check of others does not touch them.
struct Sources {
  bool friction_from_runs{};     ///< Runs at constant speed, not the sweep.
  bool mass_from_sweep{};        ///< The recommended mass is the sweep's.
  bool break_away_from_ramps{};  ///< Not from the oscillation.
};

using Keys = std::vector<std::string>;

const Keys gravity{"cog_angle", "gravity_torque", "surrogate_mass"};
const Keys mass{"gravity_torque", "surrogate_mass"};
const Keys bristle{"bristle_stiffness", "bristle_damping"};
const Keys curve{"coulomb_torque", "stribeck_speed", "viscous_coefficient", "viscous_curve"};
const Keys slopes{"stribeck_speed", "viscous_coefficient", "viscous_curve"};
const Keys per_speed{"bristle_damping", "inertia"};

Keys operator+(const Keys& a, const Keys& b) {
  Keys all = a;
  all.insert(all.end(), b.begin(), b.end());
  return all;
}

struct Consequence {
  std::string check;
  Keys touched;
  calibration::Verdict lowered_to;
};

std::vector<Consequence> consequences(const Sources& sources) {
  const Keys torque = mass + bristle + curve + Keys{"break_away_torque", "inertia"};
  const Keys everything = torque + Keys{"cog_angle"};
  const Keys of_loop =
      sources.break_away_from_ramps ? bristle : bristle + Keys{"break_away_torque"};
  const auto doubtful = calibration::Verdict::doubtful;
  const auto none = calibration::Verdict::not_identifiable;
  std::vector<Consequence> all{
      {"effort_provenance", everything, doubtful},
      {"effort_column", everything, doubtful},
      {"static_torque", torque, doubtful},
      {"joint_moves", everything, doubtful},
      {"angle_unit", everything, doubtful},
      {"clock_jitter", slopes + per_speed, doubtful},
      {"clock_gaps", slopes + per_speed + Keys{"break_away_torque"}, doubtful},
      {"speed_scale", slopes + per_speed, doubtful},
      {"run_directions", {"coulomb_torque"}, none},
      {"run_directions", {"viscous_curve"}, doubtful},
      {"run_common_angles", curve, doubtful},
      {"run_speeds", slopes, none},
      {"run_speeds", {"coulomb_torque"}, doubtful},
      {"stick_slip", curve, doubtful},
      {"torque_alive", torque, doubtful},
      {"torque_noise", everything, none},
      {"torque_saturation", everything, doubtful},
      {"torque_step", torque, doubtful},
      {"friction_dissipates", everything, none},
      {"power", torque, doubtful},
      {"torque_ripple", mass, doubtful},
      {"friction_drift", curve + Keys{"break_away_torque"}, doubtful},
      {"temperature", curve + Keys{"break_away_torque"}, doubtful},
      {"encoder_step", of_loop, none},
      {"oscillation_cycles", mass + of_loop, doubtful},
      {"oscillation_at_peak", mass, doubtful},
      {"gravity_within_torque", gravity, none},
      {"sweep_directions", {"cog_angle"}, doubtful}};
  if (!sources.break_away_from_ramps) {
    all.push_back({"oscillation_slides", {"break_away_torque"}, none});
  }
  if (sources.mass_from_sweep) all.push_back({"sweep_directions", mass, doubtful});
  if (!sources.friction_from_runs) {
    all.push_back({"sweep_directions", {"coulomb_torque"}, none});
    all.push_back({"sweep_directions", {"viscous_curve"}, doubtful});
    all.push_back({"sweep_common_angles", curve, doubtful});
  }
  return all;
}

/// Lowers the quantities that the failing checks touch, with what the check found as the reason.
void apply_data_checks(const method::checks::DataChecksResult& checks, const Sources& sources,
                       std::vector<calibration::QuantityVerdict>& quantities) {
  for (const Consequence& consequence : consequences(sources)) {
    const method::checks::DataCheck* check = checks.find(consequence.check);
    if (check == nullptr || check->state != method::checks::CheckState::fails) continue;
    for (calibration::QuantityVerdict& quantity : quantities) {
      const Keys& touched = consequence.touched;
      if (std::find(touched.begin(), touched.end(), quantity.key) == touched.end()) continue;
      calibration::lower(
          quantity, consequence.lowered_to,
          {"verdict.check_fails", {{"found", check->found}, {"consequence", check->consequence}}},
          check->experiment);
    }
  }
}

std::vector<calibration::QuantityVerdict> judge_quantities(const calibration::Calibration& c) {
  std::vector<calibration::QuantityVerdict> all = gravity_verdicts(c);
  for (const auto& room : {bristle_verdicts(c), curve_verdicts(c)}) {
    all.insert(all.end(), room.begin(), room.end());
  }
  for (const Statement& finding : c.cross_checks.findings) {
    if (!c.cross_checks.doubtful) break;
    for (std::size_t k = 1; k < 3; ++k) {
      calibration::lower(all[k], calibration::Verdict::doubtful, finding,
                         {"record.eight_positions"});
    }
  }
  const Sources sources{!c.viscous.runs.empty() && !c.viscous.from_sweep,
                        c.selection.recommended == "sweep", c.break_away.mean_Nm.has_value()};
  apply_data_checks(c.data_checks, sources, all);
  apply_truth_check(c.truth_check, c.selection.recommended, all);
  apply_limits(c.manifest.limits, c.manifest.drive.gear_ratio(), all);
  return all;
}

/// The check's title and what it found.
Statement finding_of(const method::checks::DataCheck& check) {
  return {"verdict.check",
          {{"check", Statement(Code::of("check." + check.name))}, {"found", check.found}}};
}

/// Most important first: what is wrong with the data, what does not agree, broken limits, what is
/// missing, what is to be noted.
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
  if (c.position_plan)
    add(method::hysteresis::why_more_positions(*c.position_plan, c.rough.ripple));
  for (const Statement& one : disagreements) add(one);
  for (const calibration::QuantityVerdict& quantity : judgement.quantities) {
    for (const calibration::LimitOutcome& limit : quantity.limits) {
      if (limit.state != calibration::LimitState::inside) add(limit.outcome);
    }
  }
  for (const statistics::StageReport& stage : c.stages()) {
    if (stage.state != statistics::StageState::done) add(stage.reason);
  }
  for (const Statement& one : curve_findings(c)) add(one);
  for (const calibration::TruthFinding& one : c.truth_check.findings) add(one.finding);
  for (const method::checks::DataCheck* check :
       c.data_checks.in_state(method::checks::CheckState::warns)) {
    add(finding_of(*check));
  }
  return findings;
}

Statement sentence_of(const calibration::Calibration& c, calibration::Verdict overall,
                      bool has_angle, bool has_mass, bool has_disagreement, bool limit_broken) {
  const auto failing = c.data_checks.in_state(method::checks::CheckState::fails);
  if (c.manifest.drive.kind() == joint::EffortKind::none) {
    return {"verdict.no_torque"};
  }
  if (overall == calibration::Verdict::not_identifiable) {
    if (!failing.empty() && c.q_peak_rad && !c.selection.recommended.empty()) {
      return {"verdict.data_cannot_carry", {{"found", failing.front()->found}}};
    }
    if (has_angle) return {"verdict.no_mass"};
    return has_mass ? Statement{"verdict.no_angle"} : Statement{"verdict.neither_angle_nor_mass"};
  }
  if (overall == calibration::Verdict::usable) {
    return {"verdict.usable"};
  }
  if (!failing.empty()) return {"verdict.checks_fail"};
  if (has_disagreement) return {"verdict.estimates_disagree"};
  if (limit_broken) return {"verdict.limit_not_kept"};
  if (!c.truth_check.findings.empty()) return {"verdict.own_answer_not_found"};
  return {"verdict.stage_without_data"};
}

}  // namespace

calibration::Judgement judge(const calibration::Calibration& c) {
  calibration::Judgement out;
  const std::vector<Statement>& disagreements = c.cross_checks.findings;
  out.quantities = judge_quantities(c);
  const auto is_known = [&](std::size_t k) {
    return out.quantities[k].verdict != calibration::Verdict::not_identifiable;
  };
  const bool has_angle = is_known(0);
  const bool has_mass = is_known(1) && is_known(2);
  bool limit_broken = false;
  out.verdict = calibration::Verdict::usable;
  for (const calibration::QuantityVerdict& quantity : out.quantities) {
    if (quantity.decides && quantity.verdict != calibration::Verdict::usable)
      out.verdict = calibration::Verdict::doubtful;
    for (const calibration::LimitOutcome& limit : quantity.limits) {
      limit_broken |= limit.state != calibration::LimitState::inside;
    }
  }
  if (!has_angle || !has_mass) out.verdict = calibration::Verdict::not_identifiable;
  out.sentence =
      sentence_of(c, out.verdict, has_angle, has_mass, c.cross_checks.doubtful, limit_broken);
  out.findings = collect_findings(c, out, disagreements);
  return out;
}

calibration::QuantityVerdict by_estimate(const std::string& key, const std::string& unit,
                                         const std::optional<statistics::Estimate>& estimate,
                                         const Statement& why_absent, const Statement& experiment) {
  constexpr double widest_usable = 0.3;
  calibration::QuantityVerdict q;
  q.key = key;
  q.unit = unit;
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
  } else if (!(share <= widest_usable)) {
    calibration::lower(q, calibration::Verdict::doubtful,
                       {"verdict.known_to_share", {{"percent", 100 * share}}}, experiment);
  }
  return q;
}

}  // namespace tribolog::verdict
