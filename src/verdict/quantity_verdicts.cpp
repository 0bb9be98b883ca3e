#include <algorithm>
#include <cmath>

#include "calibration/headline.h"
#include "joint/degrees.h"
#include "verdict/needs.h"
#include "verdict/quantity_rooms.h"

namespace tribolog::verdict {

using joint::Quantity;
using method::hysteresis::LuGreParameterName;

namespace {

/// Why no sweep gave the angle: the reason of a sweep that was recorded comes first.
Statement why_no_angle(const calibration::Calibration& c) {
  const statistics::StageReport& rough = c.rough.stage;
  const statistics::StageReport& precise = c.precise.stage;
  return rough.state == statistics::StageState::skipped &&
                 precise.state != statistics::StageState::skipped
             ? precise.reason
             : rough.reason;
}

void lower_by_angle(double half_width_rad, calibration::QuantityVerdict& q) {
  if (half_width_rad <= widest_with_stated(q.quantity)) return;
  calibration::lower(
      q,
      half_width_rad <= widest_known(q.quantity) ? calibration::Verdict::doubtful
                                                 : calibration::Verdict::not_identifiable,
      {"verdict.known_to_angle", {{"degrees", half_width_rad * joint::degrees_per_rad}}},
      record_a_sweep);
}

calibration::QuantityVerdict angle(const calibration::Calibration& c) {
  calibration::QuantityVerdict q;
  q.quantity = Quantity::cog_angle;
  if (!c.q_peak_rad) {
    calibration::lower(q, calibration::Verdict::not_identifiable, why_no_angle(c), record_a_sweep);
    return q;
  }
  q.estimate = c.q_peak_rad;
  lower_by_angle(c.q_peak_rad->half_width(), q);
  using method::gravity::PeakSource;
  const statistics::StageReport& source =
      c.q_peak_source == PeakSource::precise_sweep ? c.precise.stage : c.rough.stage;
  if (c.q_peak_source != PeakSource::model && source.state == statistics::StageState::partial) {
    calibration::lower(q, calibration::Verdict::doubtful, source.reason, record_a_sweep);
  }
  return q;
}

}  // namespace

void doubt_wide_intervals(std::vector<calibration::QuantityVerdict>& all) {
  for (calibration::QuantityVerdict& q : all) {
    if (!q.estimate || !q.budget || q.verdict != calibration::Verdict::usable) continue;
    const statistics::Estimate& whole = q.budget->expanded;
    if (q.quantity == Quantity::cog_angle) {
      lower_by_angle(whole.half_width(), q);
      continue;
    }
    const calibration::QuantityVerdict by_width = by_estimate(q.quantity, whole, {}, q.experiment);
    for (const Statement& reason : by_width.reasons) {
      calibration::lower(q, by_width.verdict, reason, by_width.experiment);
    }
  }
}

std::vector<calibration::QuantityVerdict> gravity_verdicts(const calibration::Calibration& c) {
  const method::hysteresis::SurrogateMass* mass = c.masses.find(c.selection.recommended);
  const Statement& why = c.masses.stage.reason;
  constexpr Code both{"record.sweep_and_oscillation"};
  std::optional<statistics::Estimate> gravity_Nm;
  std::optional<statistics::Estimate> mass_kg;
  if (mass != nullptr) {
    gravity_Nm = mass->gravity_Nm;
    mass_kg = mass->mass_kg;
  }
  std::vector<calibration::QuantityVerdict> all{
      angle(c), by_estimate(Quantity::gravity_torque, gravity_Nm, why, both),
      by_estimate(Quantity::surrogate_mass, mass_kg, why, both)};
  // Without the model of sweeps and runs, each independent way to gravity has to be present, or the
  // mass rests on one alone.
  for (const statistics::StageReport* stage : {&c.rough.stage, &c.hysteresis.stage}) {
    if (mass == nullptr || stage->state == statistics::StageState::done) continue;
    for (const Quantity quantity : {Quantity::gravity_torque, Quantity::surrogate_mass}) {
      calibration::lower(verdict_on(quantity, all), calibration::Verdict::doubtful,
                         {"verdict.nothing_independent", {{"why", stage->reason}}}, both);
    }
  }
  return all;
}

namespace {

/// Why the loop gave no parameters: the fit's own reason, or the stage's.
Statement why_no_fit(const calibration::Calibration& c) {
  const auto& fit = c.lugre;
  if (fit && !fit->reason.empty()) return fit->reason;
  if (!c.hysteresis.stage.reason.empty()) return c.hysteresis.stage.reason;
  return {"verdict.no_loop_model"};
}

/// Ramps and the level of loops together; where they disagree beyond both intervals, or the loops'
/// contact is not LuGre's, the ramps', widened to include that level: which of the two the
/// contact's model biases is not known.
std::optional<statistics::Estimate> with_loops(
    const std::optional<statistics::Estimate>& ramps_Nm,
    const std::optional<statistics::Estimate>& loop_level_Nm) {
  if (!ramps_Nm || !loop_level_Nm) return ramps_Nm;
  const double difference = std::abs(loop_level_Nm->value - ramps_Nm->value);
  const double of_level = loop_level_Nm->half_width();
  const double of_ramps = ramps_Nm->half_width();
  const double noise = std::hypot(of_ramps, of_level);
  // Of a contact that is not LuGre's the ramps are read by a law that is not its own.
  const bool is_of_other_law = of_level == 0;
  if (difference > noise || is_of_other_law) {
    return statistics::symmetric_estimate(
        ramps_Nm->value, is_of_other_law ? std::hypot(noise, difference) : difference + of_level,
        {"interval.widened_by_loops", {{"interval", ramps_Nm->method}}});
  }
  // What they have in common, as their distance to the runs, does not average.
  const double share = of_ramps * of_ramps / (of_ramps * of_ramps + of_level * of_level);
  return statistics::symmetric_estimate(std::lerp(ramps_Nm->value, loop_level_Nm->value, share),
                                        std::lerp(of_ramps, of_level, share),
                                        {"interval.of_ramps_and_loops"});
}

/// The level at which the loops slide, by the law that describes them; where that is not LuGre's,
/// without an interval. Absent where they show none, or ramps contradict it.
std::optional<statistics::Estimate> level_of_loops(const calibration::Calibration& c) {
  using method::hysteresis::ContactLaw;
  const auto level = c.lugre ? c.lugre->shown(LuGreParameterName::static_torque) : std::nullopt;
  if (!level) return std::nullopt;
  const method::hysteresis::ContactComparison& contest = c.lugre->contacts;
  if (!contest.winner || contest.winner == ContactLaw::lugre) return level;
  return statistics::symmetric_estimate(contest.find(*contest.winner)->static_Nm, 0, {});
}

/// From ramps if any broke away, else from the loop's level.
calibration::QuantityVerdict break_away(const calibration::Calibration& c,
                                        const std::optional<statistics::Estimate>& loop_level_Nm,
                                        const Statement& why) {
  const method::hysteresis::BreakAwayResult& ramps = c.break_away;
  const bool from_ramps = ramps.mean_Nm.has_value();
  const auto one_direction = loop_level_Nm ? std::nullopt : ramps.of_one_direction_Nm();
  const auto estimate = from_ramps      ? with_loops(ramps.mean_Nm, level_of_loops(c))
                        : one_direction ? one_direction
                                        : loop_level_Nm;
  const bool ramps_tell_why = !ramps.ramps.empty() && c.hysteresis.oscillations.empty();
  calibration::QuantityVerdict q =
      by_estimate(Quantity::break_away_torque, estimate, ramps_tell_why ? ramps.stage.reason : why,
                  ramps_tell_why ? Statement{"record.ramps"} : record_an_oscillation);
  if (one_direction) {
    calibration::lower(q, calibration::Verdict::doubtful, {"verdict.ramps_of_one_direction"},
                       {"record.ramps"});
  }
  if (!ramps.ramps.empty() && !from_ramps && !one_direction && !ramps_tell_why) {
    calibration::lower(q, calibration::Verdict::doubtful,
                       {"verdict.ramps_do_not_show", {{"why", ramps.stage.reason}}},
                       {"record.ramps"});
  }
  constexpr double most_apart = 0.1;
  if (from_ramps && ramps.apart > most_apart) {
    calibration::lower(q, calibration::Verdict::doubtful,
                       {"verdict.ramps_bend_otherwise", {{"percent", 100 * ramps.apart}}},
                       {"record.ramps"});
  }
  // Sliding friction cannot be larger than what it takes to start sliding.
  const std::optional<statistics::Estimate> coulomb = coulomb_torque(c);
  if (!from_ramps && loop_level_Nm && coulomb && loop_level_Nm->high < coulomb->low) {
    calibration::lower(q, calibration::Verdict::not_identifiable, {"verdict.never_broke_away"},
                       {"record.larger_amplitude"});
  }
  return q;
}

}  // namespace

std::vector<calibration::QuantityVerdict> bristle_verdicts(const calibration::Calibration& c) {
  const auto& fit = c.lugre;
  // A parameter that the loops do not show states why, and what would show it.
  const auto of_fit = [&](Quantity quantity, LuGreParameterName name,
                          const std::optional<statistics::Estimate>& instead) {
    Statement why = why_no_fit(c);
    Statement experiment = record_an_oscillation;
    std::optional<statistics::Estimate> estimate = instead;
    if (fit && !estimate) estimate = fit->shown(name);
    for (const method::hysteresis::LuGreParameter& p :
         fit ? fit->parameters : std::vector<method::hysteresis::LuGreParameter>{}) {
      if (p.name != name || p.estimate) continue;
      why = p.why_not;
      experiment = p.experiment;
    }
    return by_estimate(quantity, estimate, why, experiment);
  };
  std::vector<calibration::QuantityVerdict> all{
      break_away(c, fit ? fit->shown(LuGreParameterName::static_torque) : std::nullopt,
                 why_no_fit(c)),
      of_fit(Quantity::bristle_stiffness, LuGreParameterName::bristle_stiffness, {}),
      of_fit(Quantity::bristle_damping, LuGreParameterName::bristle_damping, {}),
      of_fit(Quantity::inertia, LuGreParameterName::inertia,
             calibration::inertia_headline(c).kgm2)};
  // A lag of the torque looks like bristle damping: a loop alone does not separate the two.
  const bool lag_is_known = !c.model.empty() || c.manifest.effects.is_stated(joint::effect::lag);
  if (!lag_is_known) {
    calibration::lower(verdict_on(Quantity::bristle_damping, all), calibration::Verdict::doubtful,
                       {"verdict.lag_unknown"}, record_runs);
  }
  // The method does not rest on these two, and slow loops hardly show them.
  verdict_on(Quantity::bristle_damping, all).decides = false;
  verdict_on(Quantity::inertia, all).decides = false;
  return all;
}

namespace {

calibration::QuantityVerdict viscous_curve(const calibration::Calibration& c) {
  calibration::QuantityVerdict q;
  q.quantity = Quantity::viscous_curve;
  const statistics::StageReport& stage = c.viscous.stage;
  if (c.viscous.runs.empty() || c.viscous.curves.empty()) {
    calibration::lower(q, calibration::Verdict::not_identifiable, stage.reason, record_runs);
    return q;
  }
  // Runs without a plateau are left out and reported; the other points remain valid.
  const bool lacks_a_few = !c.viscous.from_sweep && c.viscous.recordings_without_plateau > 0 &&
                           2 * c.viscous.recordings_without_plateau <= c.viscous.runs.size();
  if (stage.state != statistics::StageState::done && !lacks_a_few)
    calibration::lower(q, calibration::Verdict::doubtful, stage.reason, record_runs);
  if (c.quality.errors.empty()) {
    calibration::lower(q, calibration::Verdict::doubtful,
                       {"verdict.nothing_checks_curve", {{"why", c.quality.stage.reason}}},
                       record_runs);
  }
  return q;
}

}  // namespace

std::optional<statistics::Estimate> coulomb_torque(const calibration::Calibration& c) {
  return calibration::curve_headline(c).coulomb_Nm.estimate;
}

namespace {

/// A law that the runs do not support may have any parameter: a torque far beyond theirs is not an
/// estimate.
bool is_beyond_runs(const calibration::Calibration& c, double torque_Nm) {
  constexpr double most_times = 10;
  double largest = 0;
  for (const method::viscous::ConstantSpeedRun& run : c.viscous.runs) {
    largest = std::max(largest, std::abs(run.torque_Nm));
  }
  return largest > 0 && std::abs(torque_Nm) > most_times * largest;
}

}  // namespace

std::vector<calibration::QuantityVerdict> curve_verdicts(const calibration::Calibration& c) {
  const calibration::CurveHeadline headline = calibration::curve_headline(c);
  // A number is there, or why there is none.
  const auto judged = [&](Quantity quantity, const calibration::HeadlineQuantity& found,
                          const Statement& experiment) {
    const Statement& none = found.why_not.empty() ? c.friction.stage.reason : found.why_not;
    const bool is_beyond = quantity == Quantity::coulomb_torque && found.estimate &&
                           is_beyond_runs(c, found.estimate->value);
    if (is_beyond) {
      return by_estimate(quantity, std::nullopt, {"verdict.beyond_the_runs"}, experiment);
    }
    return by_estimate(quantity, found.estimate, none, experiment);
  };
  std::vector<calibration::QuantityVerdict> all{
      judged(Quantity::coulomb_torque, headline.coulomb_Nm, record_runs),
      judged(Quantity::stribeck_speed, headline.stribeck_speed_rad_s,
             {"record.speeds_about_the_dip"}),
      judged(Quantity::viscous_coefficient, headline.viscous_Nms_rad, record_runs),
      viscous_curve(c)};
  // Above the dip, says the definition; a sweep's speeds may lie within it.
  const bool is_of_sweep =
      headline.source == calibration::HeadlineSource::sweep || c.viscous.from_sweep;
  if (is_of_sweep) {
    for (const Quantity quantity : {Quantity::coulomb_torque, Quantity::viscous_coefficient}) {
      calibration::QuantityVerdict& q = verdict_on(quantity, all);
      if (!q.estimate) continue;
      calibration::lower(q, calibration::Verdict::doubtful, {"verdict.friction_of_sweep"},
                         {"record.runs"});
    }
  }
  // All three are of one law: where its Coulomb torque cannot be, nor is the rest right.
  if (headline.coulomb_Nm.estimate && headline.coulomb_Nm.estimate->value <= 0) {
    for (const Quantity quantity : {Quantity::viscous_coefficient, Quantity::stribeck_speed}) {
      calibration::lower(
          verdict_on(quantity, all), calibration::Verdict::doubtful,
          {"verdict.of_law_without_coulomb", {{"coulomb_Nm", headline.coulomb_Nm.estimate->value}}},
          record_runs);
    }
  }
  // A curve without a dip has no Stribeck velocity.
  verdict_on(Quantity::stribeck_speed, all).decides = false;
  return all;
}

}  // namespace tribolog::verdict
