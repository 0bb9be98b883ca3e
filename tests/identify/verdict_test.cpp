// The verdict on each quantity, and the manifest's limits.

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string_view>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "base/requirements.h"
#include "identify/identify.h"
#include "support/paper_joint.h"
#include "verdict/acceptance.h"
#include "verdict/judge.h"
#include "wording/words.h"

namespace tribolog::verdict_test {
namespace {

using method::checks::CheckName;

const calibration::QuantityVerdict& quantity(const calibration::Calibration& c,
                                             joint::Quantity quantity) {
  const calibration::QuantityVerdict* found = c.judgement.find(quantity);
  if (found == nullptr) throw std::logic_error("no quantity " + to_string(quantity));
  return *found;
}

/// A quantity of 10 N·m at the motor, between 9 and 11.
std::vector<calibration::QuantityVerdict> ten_Nm() {
  calibration::QuantityVerdict q;
  q.quantity = joint::Quantity::coulomb_torque;
  q.estimate = statistics::Estimate{10, 9, 11, {}};
  q.unit = "N·m";
  return {q};
}

calibration::LimitState state_of(joint::AcceptanceLimit limit, double gear_ratio = 1) {
  auto quantities = ten_Nm();
  verdict::apply_limits({limit}, gear_ratio, quantities);
  EXPECT_EQ(quantities[0].limits.size(), 1U);
  EXPECT_EQ(quantities[0].verdict == calibration::Verdict::usable,
            quantities[0].limits[0].state == calibration::LimitState::inside);
  return quantities[0].limits[0].state;
}

joint::AcceptanceLimit with_max(double max, const std::string& key = "coulomb_motor_Nm") {
  joint::AcceptanceLimit limit;
  limit.quantity = key;
  limit.max = max;
  return limit;
}

TEST(AcceptanceLimits, LookAtTheWholeInterval) {
  EXPECT_EQ(state_of(with_max(11)), calibration::LimitState::inside);
  EXPECT_EQ(state_of(with_max(10.5)), calibration::LimitState::crosses);
  EXPECT_EQ(state_of(with_max(9.5)), calibration::LimitState::crosses);
  EXPECT_EQ(state_of(with_max(8.9)), calibration::LimitState::outside);
  joint::AcceptanceLimit least;
  least.quantity = "coulomb_motor_Nm";
  least.min = 9;
  EXPECT_EQ(state_of(least), calibration::LimitState::inside);
  least.min = 10.5;
  EXPECT_EQ(state_of(least), calibration::LimitState::crosses);
  least.min = 12;
  EXPECT_EQ(state_of(least), calibration::LimitState::outside);
}

TEST(AcceptanceLimits, AreCarriedToTheirSideOfTheGear) {
  EXPECT_EQ(state_of(with_max(1101, "coulomb_joint_Nm"), 100), calibration::LimitState::inside);
  EXPECT_EQ(state_of(with_max(899, "coulomb_joint_Nm"), 100), calibration::LimitState::outside);
}

TEST(AcceptanceLimits, BoundTheWidthOfTheInterval) {
  joint::AcceptanceLimit width;
  width.quantity = "coulomb_joint_Nm";
  width.half_width_percent = 10.5;
  EXPECT_EQ(state_of(width, 50),
            calibration::LimitState::inside);  // ±10 % on either side of the gear
  width.half_width_percent = 9.5;
  EXPECT_EQ(state_of(width, 50), calibration::LimitState::outside);
  width.half_width_percent.reset();
  width.half_width = 49;
  EXPECT_EQ(state_of(width, 50), calibration::LimitState::outside);
  width.half_width = 51;
  EXPECT_EQ(state_of(width, 50), calibration::LimitState::inside);
}

TEST(AcceptanceLimits, OfWhatIsNotKnownAreNotKept) {
  auto quantities = ten_Nm();
  quantities[0].estimate.reset();
  verdict::apply_limits({with_max(100)}, 1, quantities);
  EXPECT_EQ(quantities[0].limits[0].state, calibration::LimitState::unknown);
  EXPECT_EQ(quantities[0].verdict, calibration::Verdict::doubtful);
}

TEST(Verdicts, TheNoiseFreeJointIsUsableInEveryQuantityThatDecides) {
  const joint::Dataset d = simulate::simulated_dataset(test::paper_joint());
  const calibration::Calibration c = identify::identify(d);
  ASSERT_EQ(c.judgement.quantities.size(), 11U);
  for (const calibration::QuantityVerdict& q : c.judgement.quantities) {
    // Eq. (6), which this joint follows, has neither a Coulomb torque nor one viscous coefficient.
    if (q.quantity == joint::Quantity::coulomb_torque ||
        q.quantity == joint::Quantity::viscous_coefficient) {
      EXPECT_NE(q.verdict, calibration::Verdict::usable);
      EXPECT_FALSE(q.decides);
      // Twenty speeds in both directions are there: it is not told to record them.
      const bool is_coulomb = q.quantity == joint::Quantity::coulomb_torque;
      EXPECT_TRUE(is_coulomb ? q.experiment.is("record.slower_speeds")
                             : q.experiment.is("record.faster_speeds"));
      continue;
    }
    EXPECT_EQ(q.verdict, calibration::Verdict::usable)
        << to_string(q.quantity) << ": " << wording::words(q.reasons.front());
  }
  EXPECT_EQ(c.judgement.verdict, calibration::Verdict::usable);
}

TEST(Verdicts, ABrokenLimitMakesAUsableJointDoubtful) {
  joint::Dataset d = simulate::simulated_dataset(test::paper_joint());
  d.manifest.limits = {with_max(70, "surrogate_mass_kg")};
  const calibration::Calibration c = identify::identify(d);
  EXPECT_EQ(c.judgement.verdict, calibration::Verdict::doubtful);
  EXPECT_EQ(quantity(c, joint::Quantity::surrogate_mass).verdict, calibration::Verdict::doubtful);
  EXPECT_EQ(quantity(c, joint::Quantity::gravity_torque).verdict, calibration::Verdict::usable);
  EXPECT_NE(wording::words(c.judgement.findings.front()).find("does not meet the limit"),
            std::string::npos)
      << wording::words(c.judgement.findings.front());
  d.manifest.limits = {with_max(80, "surrogate_mass_kg")};
  EXPECT_EQ(identify::identify(d).judgement.verdict, calibration::Verdict::usable);
}

const calibration::Calibration& sound_joint() {
  static const calibration::Calibration c =
      identify::identify(simulate::simulated_dataset(test::paper_joint()));
  return c;
}

/// How far behind the first a finding of this code stands; none: nothing.
std::optional<std::size_t> place_of(Code code, const calibration::Calibration& c) {
  const std::vector<Statement> findings = verdict::judge(c).findings;
  const auto at = std::find_if(findings.begin(), findings.end(),
                               [&](const Statement& one) { return one.is(code); });
  if (at == findings.end()) return std::nullopt;
  return static_cast<std::size_t>(at - findings.begin());
}

/// The same of the finding that tells an effect of the model.
std::optional<std::size_t> place_of_effect(Code effect, const calibration::Calibration& c) {
  const StatedValue named("effect", Statement(effect));
  const std::vector<Statement> findings = verdict::judge(c).findings;
  const auto at = std::find_if(findings.begin(), findings.end(), [&](const Statement& one) {
    return one.is("model.effect_shows") &&
           std::find(one.values().begin(), one.values().end(), named) != one.values().end();
  });
  if (at == findings.end()) return std::nullopt;
  return static_cast<std::size_t>(at - findings.begin());
}

TEST(Verdicts, FrictionThatChangesWithTheAngleIsToldAsAnEffect) {
  simulate::Scenario s = test::paper_joint();
  EXPECT_FALSE(place_of_effect("effect.position", sound_joint()));
  s.effects.friction_by_angle = 0.05;
  EXPECT_TRUE(
      place_of_effect("effect.position", identify::identify(simulate::simulated_dataset(s))));
}

/// Sweeps and runs of a joint whose angle was homed anew between them, by this much.
joint::Dataset of_two_homings(double by_rad) {
  joint::Dataset d = simulate::simulated_dataset(test::noisy_paper_joint(7));
  d.manifest.effects = {};
  for (joint::Recording& r : d.recordings) {
    if (r.role != joint::Role::constant_speed) continue;
    for (double& q_rad : r.q_rad) q_rad += by_rad;
  }
  return d;
}

/// Whether a finding tells the reason, or the effect that the reason names last.
bool tells(const Statement& finding, const Statement& reason) {
  if (finding == reason) return true;
  const auto& values = finding.values();
  return finding.is("model.effect_shows") && !reason.values().empty() &&
         std::find(values.begin(), values.end(), reason.values().back()) != values.end();
}

TEST(Verdicts, TheHeadlineSaysWhatIsKnownHowWellThenWhatDecidesAndWhy) {
  const calibration::Calibration c = identify::identify(of_two_homings(0.02));
  ASSERT_EQ(c.judgement.sentence.code().text(), "verdict.headline");
  const std::string sentence = wording::words(c.judgement.sentence);
  EXPECT_EQ(sentence.rfind("Friction is known to ± ", 0), 0U) << sentence;
  std::size_t doubtful = 0;
  std::size_t named = 0;
  for (const calibration::QuantityVerdict& q : c.judgement.quantities) {
    if (!q.decides || q.verdict == calibration::Verdict::usable) continue;
    ++doubtful;
    const std::string name =
        wording::words(Statement(Code::of("quantity." + to_string(q.quantity))));
    if (sentence.find(name + " is ") != std::string::npos) {
      ++named;
      EXPECT_NE(sentence.find(wording::words(q.reasons.front())), std::string::npos) << sentence;
    }
    EXPECT_TRUE(std::any_of(c.judgement.findings.begin(), c.judgement.findings.begin() + 3,
                            [&](const Statement& one) { return tells(one, q.reasons.front()); }))
        << name << ": " << wording::words(q.reasons.front());
  }
  EXPECT_GE(doubtful, 2U);
  EXPECT_EQ(named, 1U) << sentence;
}

TEST(Verdicts, TheHeadlineOfASoundJointStatesItsIntervals) {
  const calibration::Calibration c =
      identify::identify(simulate::simulated_dataset(test::noisy_paper_joint(7)));
  const std::string sentence = wording::words(c.judgement.sentence);
  double worst = 0;
  for (const calibration::FrictionAtSpeed& f : c.judgement.friction_at_speed) {
    ASSERT_EQ(f.verdict, calibration::Verdict::usable);
    worst = std::max(worst, 100 * f.torque_Nm.half_width() / f.torque_Nm.value);
  }
  EXPECT_NE(sentence.find(fmt::format("Friction is known to ± {:.2g} %", worst)), std::string::npos)
      << sentence;
  EXPECT_NE(sentence.find("Gravity torque is known to ± "), std::string::npos) << sentence;
  EXPECT_NE(sentence.find("Independent estimates of the mass agree."), std::string::npos)
      << sentence;
}

/// An effect of the model, with its largest torque.
method::model::ModelEffect effect_of(std::string_view key, double largest_Nm, double chi2) {
  method::model::ModelEffect effect;
  effect.key = key;
  effect.chi2 = chi2;
  effect.freedom = 1;
  effect.largest_Nm = {largest_Nm, 0.9 * largest_Nm, 1.1 * largest_Nm, {}};
  return effect;
}

TEST(Findings, ADisagreementStandsBehindTheOffsetThatMakesIt) {
  calibration::Calibration c = sound_joint();
  c.cross_checks.doubtful = true;
  c.cross_checks.findings = {
      {"cross_check.disagree", {{"cause", Statement{"cross_check.loop_not_steady"}}}}};
  EXPECT_EQ(place_of("cross_check.disagree", c), 0U);
  c.model.effects = {effect_of("offset", 0.04, 20)};
  EXPECT_EQ(place_of_effect("effect.offset", c), 0U);
  EXPECT_EQ(place_of("cross_check.disagree", c), 1U);
}

TEST(Findings, EffectsBeyondDoubtAreToldTheLargestFirst) {
  calibration::Calibration c = sound_joint();
  c.model.effects = {effect_of("lag", 0.01, 20), effect_of("load", 0.02, 20),
                     effect_of("drift", 0.03, 2)};
  EXPECT_TRUE(place_of_effect("effect.lag", c));
  EXPECT_LT(place_of_effect("effect.load", c), place_of_effect("effect.lag", c));
  EXPECT_FALSE(place_of_effect("effect.drift", c)) << "the recordings may not show it";
}

TEST(Findings, ATorqueThatNeverChangesShowsNothing) {
  for (const double live_percent : {0.0, 60.0}) {
    calibration::Calibration c = sound_joint();
    for (method::checks::DataCheck& check : c.data_checks.checks) {
      if (check.name != CheckName::torque_alive) continue;
      check.state = method::checks::CheckState::fails;
      check.measured = live_percent;
      check.found = {"torque_alive.constant", {{"constant", 24}, {"recordings", 24}}};
    }
    const calibration::Judgement judgement = verdict::judge(c);
    for (const joint::Quantity quantity :
         {joint::Quantity::gravity_torque, joint::Quantity::surrogate_mass,
          joint::Quantity::break_away_torque, joint::Quantity::inertia}) {
      // The model of sweeps and runs leaves out recordings of a dead torque.
      const auto where_some_live = quantity == joint::Quantity::break_away_torque
                                       ? calibration::Verdict::doubtful
                                       : calibration::Verdict::usable;
      EXPECT_EQ(judgement.find(quantity)->verdict,
                live_percent == 0 ? calibration::Verdict::not_identifiable : where_some_live)
          << joint::to_string(quantity) << " " << live_percent;
    }
  }
}

TEST(Findings, AnotherJointThatMovesStandsBeforeTheShiftOfThePeakThatItMakes) {
  calibration::Calibration c = sound_joint();
  for (method::checks::DataCheck& check : c.data_checks.checks) {
    if (check.name == CheckName::oscillation_at_peak) {
      check.state = method::checks::CheckState::fails;
      check.found = {"oscillation_at_peak.centre",
                     {{"centre_deg", 0.0}, {"peak_deg", 3.0}, {"smaller_percent", 0.1}}};
    }
  }
  EXPECT_EQ(place_of("verdict.check", c), 0U);
  method::gravity::VibrationLine swings;
  swings.frequency_Hz = 0.13;
  swings.amplitude_Nm = 0.2 * c.rough.gravity_Nm.value;
  c.rough.vibration = {swings};
  EXPECT_EQ(place_of("cause.other_joint", c), 0U);
  EXPECT_EQ(place_of("verdict.check", c), 1U);
}

TEST(Findings, SweepsAndRunsOfDifferentHomingsWidenTheAngle) {
  constexpr double by_rad = 0.02;
  const calibration::Calibration one = identify::identify(of_two_homings(0));
  const calibration::Calibration two = identify::identify(of_two_homings(by_rad));
  const auto angle_of = [](const calibration::Calibration& c) {
    return *c.judgement.find(joint::Quantity::cog_angle)->estimate;
  };
  EXPECT_FALSE(one.model.find("homing")->is_plain());
  EXPECT_TRUE(two.model.find("homing")->is_plain());
  // Nobody knows which of the two zeros is the right one.
  for (const double zero : {0.0, by_rad}) {
    EXPECT_LT(angle_of(two).low, test::true_q_peak_rad() + zero);
    EXPECT_GT(angle_of(two).high, test::true_q_peak_rad() + zero);
  }
  EXPECT_EQ(one.judgement.find(joint::Quantity::cog_angle)->verdict, calibration::Verdict::usable);
  EXPECT_EQ(two.judgement.find(joint::Quantity::cog_angle)->verdict,
            calibration::Verdict::doubtful);
  const auto& findings = two.judgement.findings;
  EXPECT_TRUE(std::any_of(findings.begin(), findings.end(), [](const Statement& finding) {
    return wording::words(finding).find("zero differs between") != std::string::npos;
  }));
}

TEST(Findings, AVibrationAtAMultipleOfTheLoopsFrequencyIsInTheLoops) {
  calibration::Calibration c = sound_joint();
  method::gravity::VibrationLine line;
  line.amplitude_Nm = 0.006 * c.hysteresis.midline_friction_Nm;
  const double loop_Hz = c.hysteresis.oscillations.front().frequency_Hz;
  for (const double order : {3.0, 3.5}) {
    line.frequency_Hz = order * loop_Hz;
    c.rough.vibration = {line};
    EXPECT_EQ(place_of("cause.vibration_in_loops", c).has_value(), order == 3.0) << order;
  }
}

TEST(Findings, AFewPeriodsAlongTheSweepAreNoneOfTheMotor) {
  calibration::Calibration c = sound_joint();
  c.rough.friction_by_angle_Nm = 0.1 * c.rough.coulomb_Nm->value;
  const auto with_periods = [&](double per_turn) {
    c.rough.friction_of_angle.lines.assign(1, {});
    c.rough.friction_of_angle.lines.front().periods_per_turn = per_turn;
  };
  with_periods(2);
  EXPECT_TRUE(place_of("cause.friction_by_motor_angle", c));
  with_periods(0.07);
  EXPECT_FALSE(place_of("cause.friction_by_motor_angle", c));
  EXPECT_TRUE(place_of("cause.friction_along_angle", c));
}

TEST(Findings, RippleWithoutAPeriodCountsNoLines) {
  calibration::Calibration c = sound_joint();
  c.rough.ripple_Nm = 0.1;
  c.rough.ripple.lines.clear();
  EXPECT_TRUE(place_of("cause.ripple_without_lines", c));
  EXPECT_FALSE(place_of("cause.ripple", c));
}

TEST(Findings, ALagThatTheRecordingsShowIsToldAndTakenOffTheLoops) {
  for (const double delay_s : {0.0, 0.005}) {
    simulate::Scenario s = test::paper_joint();
    s.noise.effects.torque_delay_s = delay_s;
    joint::Dataset d = simulate::simulated_dataset(s);
    d.manifest.effects = {};  // as of a log, of which nothing is stated
    const calibration::Calibration c = identify::identify(d, {.truth_runs = 0});
    const method::model::ModelEffect* lag = c.model.find("lag");
    ASSERT_TRUE(lag != nullptr && lag->coefficient);
    EXPECT_LE(lag->coefficient->low, delay_s);
    EXPECT_GE(lag->coefficient->high, delay_s);
    EXPECT_EQ(place_of_effect("effect.lag", c).has_value(), delay_s > 0);
  }
}

TEST(Verdicts, ARunWithoutAPlateauIsToldAndLeavesTheCurveOfTheOthers) {
  joint::Dataset d = simulate::simulated_dataset(test::noisy_paper_joint(7));
  std::size_t cut = 0;
  for (auto one = d.recordings.rbegin(); one != d.recordings.rend(); ++one) {  // the fastest last
    joint::Recording& r = *one;
    if (r.role != joint::Role::constant_speed || r.dq_rad_s.empty() || cut == 2) continue;
    ++cut;
    // Stopped while it still accelerates.
    const auto faster = [](double a, double b) { return std::abs(a) < std::abs(b); };
    const double fastest =
        std::abs(*std::max_element(r.dq_rad_s.begin(), r.dq_rad_s.end(), faster));
    const auto stop = std::find_if(r.dq_rad_s.begin(), r.dq_rad_s.end(),
                                   [&](double speed) { return std::abs(speed) > 0.7 * fastest; });
    const auto kept = static_cast<std::size_t>(stop - r.dq_rad_s.begin());
    for (std::vector<double>* channel : {&r.t_s, &r.q_rad, &r.dq_rad_s, &r.torque_Nm}) {
      channel->resize(kept);
    }
  }
  const calibration::Calibration c = identify::identify(d, {.truth_runs = 0});
  EXPECT_EQ(c.viscous.recordings_without_plateau, cut);
  const calibration::QuantityVerdict& curve = quantity(c, joint::Quantity::viscous_curve);
  EXPECT_EQ(curve.verdict, calibration::Verdict::usable)
      << (curve.reasons.empty() ? "" : wording::words(curve.reasons.front()));
  EXPECT_TRUE(
      std::any_of(c.judgement.findings.begin(), c.judgement.findings.end(),
                  [](const Statement& one) { return one.is("viscous.runs_without_plateau"); }));
}

TEST(Verdicts, OneDirectionLeavesCoulombAndOffsetInseparable) {
  simulate::Scenario s = test::paper_joint();
  s.rough_sweep->both_directions = false;
  s.constant_speed->both_directions = false;
  joint::Dataset d = simulate::simulated_dataset(s);
  d.manifest.effects = {};  // an offset is not stated as absent
  const calibration::Calibration c = identify::identify(d);
  const calibration::QuantityVerdict& coulomb = quantity(c, joint::Quantity::coulomb_torque);
  EXPECT_NE(coulomb.verdict, calibration::Verdict::usable);
  const method::model::ModelQuantity* found = c.model.find(joint::Quantity::coulomb_torque);
  ASSERT_TRUE(found != nullptr && !found->shares.empty());
  const auto asymmetry =
      std::find_if(found->shares.begin(), found->shares.end(),
                   [](const auto& share) { return share.effect == "asymmetry"; });
  ASSERT_NE(asymmetry, found->shares.end());
  EXPECT_GT(asymmetry->share, 0.5);
  // The loop goes both ways, so its gravity is as good as ever.
  EXPECT_EQ(quantity(c, joint::Quantity::bristle_stiffness).verdict, calibration::Verdict::usable);
}

TEST(Verdicts, WithoutTorqueNothingThatNeedsItIsIdentifiable) {
  joint::Dataset d = simulate::simulated_dataset(test::paper_joint());
  d.manifest.drive = joint::Drive(100, joint::EffortKind::none, joint::Side::motor);
  for (joint::Recording& r : d.recordings) r.torque_Nm.clear();
  const calibration::Calibration c = identify::identify(d);
  EXPECT_EQ(c.judgement.verdict, calibration::Verdict::not_identifiable);
  for (const calibration::QuantityVerdict& q : c.judgement.quantities) {
    EXPECT_EQ(q.verdict, calibration::Verdict::not_identifiable) << to_string(q.quantity);
    EXPECT_NE(wording::words(q.reasons.front()).find("no torque was recorded"), std::string::npos)
        << to_string(q.quantity);
    EXPECT_FALSE(q.experiment.empty()) << to_string(q.quantity);
  }
  // What the motion says is still said.
  EXPECT_EQ(c.data_checks.find(CheckName::speed_scale)->state, method::checks::CheckState::passed);
  EXPECT_EQ(c.data_checks.find(CheckName::run_common_angles)->state,
            method::checks::CheckState::passed);
  EXPECT_EQ(c.data_checks.find(CheckName::torque_noise)->state,
            method::checks::CheckState::not_applicable);
}

// Nothing but a loop hundreds of times as wide as the bristle bends. The drive jumps to its speed
// at once, and the first sample holds four times the torque of the loop.
calibration::Calibration of_wide_loop_alone(double amplitude_rad) {
  simulate::Scenario s = test::paper_joint();
  s.rough_sweep.reset();
  s.precise_sweep.reset();
  s.constant_speed.reset();
  s.oscillation->amplitude_rad = amplitude_rad;
  s.oscillation->record_bristle = false;
  return identify::identify(test::simulated_dataset(s));
}

TEST(Verdicts, AModelThatMissesAWideLoopGivesNoUsableBreakAwayTorque) {
  const calibration::QuantityVerdict q =
      quantity(of_wide_loop_alone(0.03), joint::Quantity::break_away_torque);
  const double truth = test::paper_contact().parameters().static_Nm;
  if (!q.estimate || std::abs(q.estimate->value / truth - 1) < 0.02) return;
  EXPECT_NE(q.verdict, calibration::Verdict::usable) << q.estimate->value;
}

TEST(Verdicts, AWideLoopReachesSliding) {
  const calibration::Calibration c = of_wide_loop_alone(0.01);
  EXPECT_EQ(c.data_checks.find(CheckName::oscillation_slides)->state,
            method::checks::CheckState::passed);
  const calibration::QuantityVerdict q = quantity(c, joint::Quantity::break_away_torque);
  EXPECT_EQ(q.verdict, calibration::Verdict::usable);
  EXPECT_NEAR(present(q.estimate).value, test::paper_contact().parameters().static_Nm, 1e-3);
}

}  // namespace
}  // namespace tribolog::verdict_test
