#include "verdict/judge.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include <fmt/format.h>

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
      calibration::lower(
          *it, calibration::Verdict::doubtful, finding.words,
          "a motion that shows it better, or less noise: the known-truth check says how far off "
          "it comes back");
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

/// Lowers the quantities that the failing checks touch, with the check's words as the reason.
void apply_data_checks(const method::checks::DataChecksResult& checks, const Sources& sources,
                       std::vector<calibration::QuantityVerdict>& quantities) {
  for (const Consequence& consequence : consequences(sources)) {
    const method::checks::DataCheck* check = checks.find(consequence.check);
    if (check == nullptr || check->state != method::checks::CheckState::fails) continue;
    for (calibration::QuantityVerdict& quantity : quantities) {
      const Keys& touched = consequence.touched;
      if (std::find(touched.begin(), touched.end(), quantity.key) == touched.end()) continue;
      calibration::lower(quantity, consequence.lowered_to, check->found + ": " + check->consequence,
                         check->experiment);
    }
  }
}

std::vector<calibration::QuantityVerdict> judge_quantities(const calibration::Calibration& c) {
  std::vector<calibration::QuantityVerdict> all = gravity_verdicts(c);
  for (const auto& room : {bristle_verdicts(c), curve_verdicts(c)}) {
    all.insert(all.end(), room.begin(), room.end());
  }
  for (const std::string& words : c.cross_checks.findings) {
    if (!c.cross_checks.doubtful) break;
    for (std::size_t k = 1; k < 3; ++k) {
      calibration::lower(
          all[k], calibration::Verdict::doubtful, words,
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
std::vector<std::string> collect_findings(const calibration::Calibration& c,
                                          const calibration::Judgement& judgement,
                                          const std::vector<std::string>& disagreements) {
  std::vector<std::string> findings;
  const auto add = [&](const std::string& finding) {
    const bool is_new = std::find(findings.begin(), findings.end(), finding) == findings.end();
    if (!finding.empty() && is_new) findings.push_back(finding);
  };
  for (const method::checks::DataCheck* check :
       c.data_checks.in_state(method::checks::CheckState::fails)) {
    add(check->title + ": " + check->found);
  }
  if (c.position_plan) add(method::hysteresis::ripple_in_words(*c.position_plan, c.rough.ripple));
  for (const std::string& words : disagreements) add(words);
  for (const calibration::QuantityVerdict& quantity : judgement.quantities) {
    for (const calibration::LimitOutcome& limit : quantity.limits) {
      if (limit.state != calibration::LimitState::inside) add(limit.words);
    }
  }
  for (const statistics::StageReport& stage : c.stages()) {
    if (stage.state != statistics::StageState::done) add(stage.reason);
  }
  for (const std::string& words : curve_findings(c)) add(words);
  for (const calibration::TruthFinding& finding : c.truth_check.findings) add(finding.words);
  for (const method::checks::DataCheck* check :
       c.data_checks.in_state(method::checks::CheckState::warns)) {
    add(check->title + ": " + check->found);
  }
  return findings;
}

std::string sentence_of(const calibration::Calibration& c, calibration::Verdict overall,
                        bool has_angle, bool has_mass, bool has_disagreement, bool limit_broken) {
  const auto failing = c.data_checks.in_state(method::checks::CheckState::fails);
  if (c.manifest.drive.kind() == joint::EffortKind::none) {
    return "No torque was recorded: the motion alone shows neither gravity nor friction.";
  }
  if (overall == calibration::Verdict::not_identifiable) {
    if (!failing.empty() && c.q_peak_rad && !c.selection.recommended.empty()) {
      return "The data cannot carry an identification: " + failing.front()->found + ".";
    }
    return !has_angle && !has_mass
               ? "Neither the centre of gravity nor the surrogate mass can be found in these "
                 "recordings."
           : has_angle ? "The surrogate mass cannot be found in these recordings."
                       : "The angle of the centre of gravity cannot be found in these recordings.";
  }
  if (overall == calibration::Verdict::usable) {
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

calibration::Judgement judge(const calibration::Calibration& c) {
  calibration::Judgement out;
  const std::vector<std::string>& disagreements = c.cross_checks.findings;
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

const char* const record_a_sweep =
    "slow sweep over the joint's range, across the gravity peak, in both directions";
const char* const record_an_oscillation =
    "ten cycles of a micro-oscillation about the gravity peak, at eight positions spread over one "
    "turn of the motor, resolved into at least fifty encoder steps";
const char* const record_runs =
    "ten to twenty constant speeds, from the slowest smooth one to the fastest allowed, in both "
    "directions over the same angles";

calibration::QuantityVerdict by_estimate(const std::string& key, const std::string& words,
                                         const std::string& unit,
                                         const std::optional<statistics::Estimate>& estimate,
                                         const std::string& why_absent,
                                         const std::string& experiment) {
  constexpr double widest_usable = 0.3;
  calibration::QuantityVerdict q;
  q.key = key;
  q.words = words;
  q.unit = unit;
  if (!estimate || !std::isfinite(estimate->value)) {
    calibration::lower(q, calibration::Verdict::not_identifiable, why_absent, experiment);
    return q;
  }
  q.estimate = estimate;
  const double share = estimate->half_width() / std::abs(estimate->value);
  if (!(estimate->low > 0)) {
    calibration::lower(q, calibration::Verdict::not_identifiable,
                       fmt::format("the data do not show it: its 95 % interval reaches {}",
                                   estimate->low < 0 ? "below zero" : "zero"),
                       experiment);
  } else if (!(share <= widest_usable)) {
    calibration::lower(q, calibration::Verdict::doubtful,
                       fmt::format("known to ± {:.0f} % only", 100 * share), experiment);
  }
  return q;
}

}  // namespace tribolog::verdict
