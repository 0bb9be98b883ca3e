// Logs of robots that exist. They are not part of the project; see support/real_logs.h.

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string_view>
#include <tuple>
#include <utility>

#include <gtest/gtest.h>

#include "identify/identify.h"
#include "ingest/dataset/dataset_file.h"
#include "joint/degrees.h"
#include "support/check_findings.h"
#include "support/real_logs.h"
#include "wording/words.h"

namespace tribolog::real_log_test {
namespace {

using method::checks::CheckName;
using method::hysteresis::Estimator;
using method::hysteresis::LuGreParameterName;
using method::selection::CurveReference;

using test::findings_of;

calibration::Calibration identify_manifest(const std::string& name, joint::Dataset& dataset) {
  dataset = ingest::dataset::read_dataset(std::string(TRIBOLOG_SOURCE_DIR) + "/tests/data/" + name);
  return identify::identify(dataset);
}

TEST(RealLog, Ur10eJoint2) {
  TRIBOLOG_NEEDS_REAL_LOG("ur10e_jointwise/joint_2.csv");
  joint::Dataset dataset;
  const calibration::Calibration c = identify_manifest("ur10e_joint_2.toml", dataset);
  ASSERT_TRUE(c.rough.found);
  // 10.2 A at 10.696 N·m/A.
  EXPECT_NEAR(c.rough.gravity_Nm.value / (10.2 * 10.696), 1, 0.04);
  EXPECT_EQ(c.quality.reference, CurveReference::direction_difference);
  EXPECT_EQ(c.hysteresis.stage.state, statistics::StageState::not_identifiable);
  ASSERT_TRUE(c.hysteresis.encoder_step_rad && c.hysteresis.presliding_travel_rad);
  EXPECT_NEAR(*c.hysteresis.encoder_step_rad, 1e-4, 1e-8);
  EXPECT_TRUE(c.hysteresis.step_is_of_print);
  // "Six steps of the encoder."
  EXPECT_NEAR(*c.hysteresis.presliding_travel_rad / *c.hysteresis.encoder_step_rad, 6, 4);
  EXPECT_NE(c.judgement.verdict, calibration::Verdict::usable);
  // Published for the joint, from a fit of the whole arm: a single joint agrees within 10 to 20 %.
  EXPECT_NEAR(c.model.find(joint::Quantity::coulomb_torque)->estimate / 13.27, 1, 0.2);
  EXPECT_NEAR(c.model.find(joint::Quantity::viscous_coefficient)->estimate / 20.22, 1, 0.2);
  // The load is nothing where the arm stands upright: the peak lies level.
  EXPECT_NEAR(c.q_peak_rad->value * joint::degrees_per_rad, -180, 1.5);
}

TEST(RealLog, Ur10eJoint3) {
  TRIBOLOG_NEEDS_REAL_LOG("ur10e_jointwise/joint_3.csv");
  joint::Dataset dataset;
  const calibration::Calibration c = identify_manifest("ur10e_joint_3.toml", dataset);
  ASSERT_TRUE(c.rough.found);
  EXPECT_NEAR(c.rough.gravity_Nm.value / (4.37 * 8.457), 1, 0.03);
  EXPECT_EQ(c.hysteresis.stage.state, statistics::StageState::not_identifiable);
  EXPECT_NEAR(c.q_peak_rad->value * joint::degrees_per_rad, -90, 1.0);
}

const calibration::QuantityVerdict& verdict_on(const calibration::Calibration& c,
                                               joint::Quantity which) {
  const auto& all = c.judgement.quantities;
  return *std::find_if(all.begin(), all.end(), [&](const auto& q) { return q.quantity == which; });
}

/// By hand, over all moving samples.
struct DamiaoMotor {
  const char* manifest;
  const char* log;
  double coulomb_Nm, viscous_Nms_rad, inertia_kgm2;
};

// The angle is logged modulo 25 rad, no number of turns, and the speed is off by a factor.
TEST(RealLog, DamiaoMotorsGoOnThroughTheEndsOfTheirAngle) {
  for (const DamiaoMotor& motor :
       {DamiaoMotor{"damiao_motor_3.toml", "damiao/motor_03.npz", 0.495, 0.038, 0.030},
        DamiaoMotor{"damiao_motor_5.toml", "damiao/motor_05.npz", 0.103, 0.0032, 0.0004}}) {
    TRIBOLOG_NEEDS_REAL_LOG(motor.log);
    joint::Dataset dataset;
    const calibration::Calibration c = identify_manifest(motor.manifest, dataset);
    const std::vector<std::string> found = findings_of(c.data_checks);
    EXPECT_EQ(std::count(found.begin(), found.end(), "speed_scale"), 1) << motor.log;
    for (const auto& [which, by_hand, near] :
         {std::tuple{joint::Quantity::coulomb_torque, motor.coulomb_Nm, 0.15},
          // By hand, the slow speeds' dip is in the line, which makes it flatter.
          std::tuple{joint::Quantity::viscous_coefficient, motor.viscous_Nms_rad, 0.25},
          std::tuple{joint::Quantity::inertia, motor.inertia_kgm2, 1.0}}) {
      const calibration::QuantityVerdict& q = verdict_on(c, which);
      ASSERT_TRUE(q.estimate) << motor.log << " " << to_string(which);
      EXPECT_NEAR(q.estimate->value / by_hand, 1, near) << motor.log << " " << to_string(which);
      const double margin = which == joint::Quantity::viscous_coefficient ? 0.1 : 0.01;
      EXPECT_LE(q.estimate->low * (1 - margin), by_hand) << motor.log << " " << to_string(which);
      EXPECT_GE(q.estimate->high * (1 + margin), by_hand) << motor.log << " " << to_string(which);
    }
  }
}

// One direction alone, and losses that rise ever less with the speed.
TEST(RealLog, MoteusCoulombTorqueIsNotNegativeAndNotUsable) {
  TRIBOLOG_NEEDS_REAL_LOG("moteus_dynamometer/futek_test_27_04_2021_17-39-20.csv");
  joint::Dataset dataset;
  const calibration::Calibration c = identify_manifest("moteus_dynamometer.toml", dataset);
  const calibration::QuantityVerdict& coulomb = verdict_on(c, joint::Quantity::coulomb_torque);
  ASSERT_TRUE(coulomb.estimate);
  EXPECT_GE(coulomb.estimate->value, 0);
  EXPECT_LE(coulomb.estimate->low, 0.025);
  EXPECT_GE(coulomb.estimate->high, 0.025);
  EXPECT_NE(coulomb.verdict, calibration::Verdict::usable);
}

TEST(RealLog, LuGreServoShowsInertiaAndFrictionWithoutGravity) {
  TRIBOLOG_NEEDS_REAL_LOG("lugre_servo/LuGre_J_1.txt");
  joint::Dataset dataset;
  const calibration::Calibration c = identify_manifest("lugre_servo.toml", dataset);
  // By hand: 1.995e-4 kg·m², 2.47e-4 N·m·s/rad.
  const calibration::QuantityVerdict& inertia = verdict_on(c, joint::Quantity::inertia);
  ASSERT_TRUE(inertia.estimate);
  EXPECT_NEAR(inertia.estimate->value / 1.995e-4, 1, 0.08);
  const calibration::QuantityVerdict& viscous = verdict_on(c, joint::Quantity::viscous_coefficient);
  ASSERT_TRUE(viscous.estimate);
  EXPECT_LT(viscous.estimate->low, 1.05 * 2.47e-4);
  EXPECT_GT(viscous.estimate->high, 2.47e-4);
  // By hand 27.2 and 34.2 mN·m by direction. Usable is what is known to 10 %.
  const calibration::QuantityVerdict& coulomb = verdict_on(c, joint::Quantity::coulomb_torque);
  ASSERT_TRUE(coulomb.estimate);
  EXPECT_NEAR(coulomb.estimate->value, 0.0307, 0.1 * 0.0307);
  // The ramps show what the sine, five steps of the encoder wide, does not.
  const calibration::QuantityVerdict& break_away =
      verdict_on(c, joint::Quantity::break_away_torque);
  EXPECT_EQ(break_away.verdict, calibration::Verdict::doubtful);
  ASSERT_TRUE(break_away.estimate);
  EXPECT_LT(break_away.estimate->low, 0.0255);
  EXPECT_GT(break_away.estimate->high, 0.031);
  EXPECT_EQ(verdict_on(c, joint::Quantity::bristle_stiffness).verdict,
            calibration::Verdict::not_identifiable);
  // A torque of zero before and behind the motion is a command, and none that was held.
  const method::checks::DataCheck* held = c.data_checks.find(CheckName::torque_held);
  ASSERT_NE(held, nullptr);
  EXPECT_NE(held->state, method::checks::CheckState::fails);
}

TEST(RealLog, NothingIsUsableOfAJointThatSlipsNorOfOneThatAllOthersMove) {
  for (const auto& [manifest, log] :
       {std::pair{"openarm_joint4.toml", "openarm_joint4/fid_4.npz"},
        std::pair{"kuka_joint3.toml", "kuka_lwr4/measurements_1.npz"}}) {
    TRIBOLOG_NEEDS_REAL_LOG(log);
    joint::Dataset dataset;
    for (const auto& q : identify_manifest(manifest, dataset).judgement.quantities) {
      EXPECT_NE(q.verdict, calibration::Verdict::usable) << log << " " << to_string(q.quantity);
    }
  }
}

// The arm starts within five samples, and then runs over ripple that its controller follows: that
// is no inertia, five times what the arm has, nor a lag of 50 ms.
TEST(RealLog, CiceseRippleIsNoInertia) {
  TRIBOLOG_NEEDS_REAL_LOG("cicese_joint1/presliding/sine_j1_rep1.csv");
  joint::Dataset dataset;
  const calibration::Calibration c = identify_manifest("cicese_joint1.toml", dataset);
  const method::model::ModelEffect* lag = c.model.find("lag");
  ASSERT_TRUE(lag != nullptr && lag->coefficient);
  EXPECT_LT(lag->coefficient->low, 0.005);
  const calibration::QuantityVerdict& inertia = verdict_on(c, joint::Quantity::inertia);
  EXPECT_TRUE(inertia.verdict != calibration::Verdict::usable ||
              (inertia.estimate->low < 2.8 && inertia.estimate->high > 2.5));
}

bool has_finding(const calibration::Calibration& c, const std::string& words) {
  return std::any_of(c.judgement.findings.begin(), c.judgement.findings.end(),
                     [&](const Statement& finding) {
                       return wording::words(finding).find(words) != std::string::npos;
                     });
}

TEST(RealLog, CiceseFrictionOfEachDirectionIsThePublishedOne) {
  TRIBOLOG_NEEDS_REAL_LOG("cicese_joint1/presliding/sine_j1_rep1.csv");
  joint::Dataset dataset;
  const calibration::Calibration c = identify_manifest("cicese_joint1.toml", dataset);
  // Of a line through the runs of 10 to 90 °/s, rising and falling.
  constexpr double coulomb_Nm[] = {12.4401, 10.9366};
  constexpr double viscous_Nms_rad[] = {3.4419, 2.8016};
  const method::model::ModelQuantity* coulomb = c.model.find(joint::Quantity::coulomb_torque);
  const method::model::ModelQuantity* viscous = c.model.find(joint::Quantity::viscous_coefficient);
  ASSERT_TRUE(coulomb != nullptr && viscous != nullptr);
  EXPECT_LT(coulomb->low, (coulomb_Nm[0] + coulomb_Nm[1]) / 2);
  EXPECT_GT(coulomb->high, (coulomb_Nm[0] + coulomb_Nm[1]) / 2);
  EXPECT_LT(viscous->low, (viscous_Nms_rad[0] + viscous_Nms_rad[1]) / 2);
  EXPECT_GT(viscous->high, (viscous_Nms_rad[0] + viscous_Nms_rad[1]) / 2);
  const method::model::ModelEffect* offset = c.model.find("offset");
  ASSERT_NE(offset, nullptr);
  EXPECT_LT(offset->largest_Nm.low, (coulomb_Nm[0] - coulomb_Nm[1]) / 2);
  EXPECT_GT(offset->largest_Nm.high, (coulomb_Nm[0] - coulomb_Nm[1]) / 2);
  EXPECT_FALSE(c.model.law.carries_waiboer());
}

TEST(RealLog, CiceseGravityComesFromTheRuns) {
  TRIBOLOG_NEEDS_REAL_LOG("cicese_joint1/presliding/sine_j1_rep1.csv");
  joint::Dataset dataset;
  const calibration::Calibration c = identify_manifest("cicese_joint1.toml", dataset);
  const method::hysteresis::SurrogateMass* of_model = c.masses.find(Estimator::model);
  ASSERT_NE(of_model, nullptr);
  EXPECT_NEAR(of_model->gravity_Nm.value / 38.465, 1, 0.03);
  EXPECT_LE(of_model->gravity_Nm.low, 38.465);
  EXPECT_GE(of_model->gravity_Nm.high, 38.465);
  EXPECT_NEAR(c.q_peak_rad->value * joint::degrees_per_rad, 90, 2);
  EXPECT_EQ(c.q_peak_source, method::gravity::PeakSource::model);
  EXPECT_EQ(c.selection.recommended, Estimator::model);
  // The oscillations hang 90° below the peak: a mass from them would be friction over nothing.
  EXPECT_EQ(c.masses.find(Estimator::midline), nullptr);
  ASSERT_EQ(c.manifest.known_loads.size(), 1U);
  EXPECT_GT(c.manifest.known_loads[0].samples, 30000U);
  EXPECT_NEAR(c.manifest.known_loads[0].largest_Nm, 1.825, 1e-3);
  EXPECT_TRUE(has_finding(c, "the directions share no angle"));
  EXPECT_TRUE(has_finding(c, "every speed in both directions over the same angles would give it"));
  EXPECT_EQ(c.quality.reference, CurveReference::none);
}

TEST(RealLog, CiceseSpeedComesFromTheAngle) {
  TRIBOLOG_NEEDS_REAL_LOG("cicese_joint1/presliding/sine_j1_rep1.csv");
  joint::Dataset dataset;
  const calibration::Calibration c = identify_manifest("cicese_joint1.toml", dataset);
  for (joint::Recording& r : dataset.recordings) r.dq_rad_s.clear();
  const calibration::Calibration without = identify::identify(dataset);
  ASSERT_EQ(c.viscous.runs.size(), without.viscous.runs.size());
  for (std::size_t i = 0; i < c.viscous.runs.size(); ++i) {
    EXPECT_EQ(c.viscous.runs[i].speed_rad_s, without.viscous.runs[i].speed_rad_s);
  }
}

TEST(RealLog, CiceseBreakAwayAndLoops) {
  TRIBOLOG_NEEDS_REAL_LOG("cicese_joint1/breakaway/breakaway_j1_05_exp.csv");
  joint::Dataset dataset;
  const calibration::Calibration c = identify_manifest("cicese_break_away.toml", dataset);
  ASSERT_EQ(c.break_away.ramps.size(), 10U);
  // The first ramp stops at 10.07 N·m without a slip, and its torque is not quite even.
  EXPECT_EQ(c.break_away.censored, 1U);
  EXPECT_FALSE(c.break_away.ramps.front().broke_away);
  EXPECT_NEAR(c.break_away.ramps.front().friction_Nm, 10.054, 0.001);
  EXPECT_NE(wording::words(c.break_away.stage.reason).find("larger than 10.05 N·m (censored"),
            std::string::npos);
  ASSERT_TRUE(c.break_away.rising_Nm && c.break_away.falling_Nm);
  EXPECT_NEAR(c.break_away.falling_Nm->value, 11.8, 0.3);  // the first leap in each of the plots
  EXPECT_LT(c.break_away.rising_Nm->low, c.break_away.falling_Nm->value);
  // Closed loops of 2.8e-4 rad.
  ASSERT_EQ(c.loop_shapes.size(), 3U);
  for (const method::hysteresis::LoopShape& shape : c.loop_shapes) {
    EXPECT_TRUE(shape.closes) << shape.recording;
    EXPECT_NEAR(shape.width_rad / 2.8e-4, 1, 0.1) << shape.recording;
    ASSERT_TRUE(shape.stiffness_Nm_rad) << shape.recording;
    EXPECT_NEAR(shape.stiffness_Nm_rad->value / 1.9e5, 1, 0.2) << shape.recording;
    EXPECT_LT(shape.stiffness_Nm_rad->half_width() / shape.stiffness_Nm_rad->value, 0.2);
  }
}

bool overlap(const statistics::Estimate& a, const statistics::Estimate& b) {
  return a.low <= b.high && b.low <= a.high;
}

TEST(RealLog, CiceseTorqueDrivenLoopsGiveAStiffness) {
  TRIBOLOG_NEEDS_REAL_LOG("cicese_joint1/presliding/sine_j1_rep1.csv");
  joint::Dataset dataset;
  const calibration::Calibration c = identify_manifest("cicese_break_away.toml", dataset);
  ASSERT_TRUE(c.lugre && c.lugre->converged);
  const method::hysteresis::LuGreFit& f = *c.lugre;
  const auto stiffness = f.shown(LuGreParameterName::bristle_stiffness);
  ASSERT_TRUE(stiffness);
  ASSERT_EQ(f.loops.size(), 3U);
  ASSERT_EQ(c.loop_shapes.size(), 3U);
  std::size_t k = 0;
  for (const joint::Recording* whole : dataset.with_role(joint::Role::oscillation)) {
    const method::hysteresis::LuGreLoop& loop = f.loops[k];
    EXPECT_LT(loop.systematic_Nm / loop.height_Nm, 0.08) << loop.recording;
    if (loop.traced) {
      ASSERT_TRUE(loop.traced->model_turn_stiffness_Nm_rad);
      EXPECT_TRUE(
          overlap(*loop.traced->turn_stiffness_Nm_rad, *loop.traced->model_turn_stiffness_Nm_rad));
      // The tangent behind a reversal is between one and two times the bristles' stiffness.
      EXPECT_GT(loop.traced->turn_stiffness_Nm_rad->high, stiffness->low);
      EXPECT_LT(loop.traced->turn_stiffness_Nm_rad->low, 2 * stiffness->high);
    }
    // The same by the other way: the shape of the loop that the model's torque makes.
    joint::Recording model = *whole;
    const method::hysteresis::LoopTrace& trace = c.curves.loops[k];
    const auto offset = static_cast<std::ptrdiff_t>(
        std::find(whole->t_s.begin(), whole->t_s.end(), trace.t_s.front()) - whole->t_s.begin());
    std::copy(trace.model_torque_Nm.begin(), trace.model_torque_Nm.end(),
              model.torque_Nm.begin() + offset);
    const auto shapes = method::hysteresis::describe_loops({&model}, 1);
    ASSERT_TRUE(shapes.size() == 1 && shapes[0].stiffness_Nm_rad);
    RecordProperty("measured_" + std::to_string(k),
                   std::to_string(c.loop_shapes[k].stiffness_Nm_rad->value));
    RecordProperty("model_" + std::to_string(k), std::to_string(shapes[0].stiffness_Nm_rad->value));
    // Where they differ by more than both intervals, the fit has to say that the model is wrong.
    if (!overlap(*shapes[0].stiffness_Nm_rad, *c.loop_shapes[k].stiffness_Nm_rad)) {
      EXPECT_NE(wording::words(f.reason).find("does not follow LuGre"), std::string::npos)
          << wording::words(f.reason);
    }
    ++k;
  }
  // The joint holds far more in the ramps than the 6 N·m of the loops, which creep.
  EXPECT_NE(wording::words(f.reason).find("the loops creep"), std::string::npos)
      << wording::words(f.reason);
  EXPECT_FALSE(f.shown(LuGreParameterName::coulomb_torque));
  EXPECT_FALSE(f.shown(LuGreParameterName::inertia)) << "at such speeds inertia is nothing";
}

const calibration::QuantityVerdict& quantity(const calibration::Calibration& c,
                                             joint::Quantity quantity) {
  const calibration::QuantityVerdict* found = c.judgement.find(quantity);
  if (found == nullptr) throw std::logic_error("no quantity " + to_string(quantity));
  return *found;
}

/// Of the quantity's break-away torque: the ramps', while the loops' own level is withdrawn.
void expect_level_by_ramps_alone(const calibration::Calibration& c) {
  ASSERT_TRUE(c.lugre && c.lugre->converged);
  EXPECT_FALSE(c.lugre->shown(LuGreParameterName::static_torque));
  ASSERT_TRUE(c.break_away.mean_Nm && quantity(c, joint::Quantity::break_away_torque).estimate);
  EXPECT_EQ(quantity(c, joint::Quantity::break_away_torque).estimate->value,
            c.break_away.mean_Nm->value);
}

TEST(RealLog, CiceseRampsContradictTheSinesOfJoint1) {
  TRIBOLOG_NEEDS_REAL_LOG("cicese_joint1/presliding/sine_j1_rep1.csv");
  joint::Dataset dataset;
  const calibration::Calibration c = identify_manifest("cicese_break_away.toml", dataset);
  expect_level_by_ramps_alone(c);
  EXPECT_TRUE(c.lugre->shown(LuGreParameterName::bristle_stiffness));
  // Published: Coulomb +12.44 and -10.94 N·m.
  EXPECT_NEAR(c.break_away.mean_Nm->value, (12.44 + 10.94) / 2, 1);
}

TEST(RealLog, CiceseRampsContradictTheSinesOfJoint2) {
  TRIBOLOG_NEEDS_REAL_LOG("cicese_joint2/sine_j2_1.csv");
  joint::Dataset dataset;
  const calibration::Calibration c = identify_manifest("cicese_joint2.toml", dataset);
  expect_level_by_ramps_alone(c);
  ASSERT_EQ(c.break_away.ramps.size(), 6U);
  for (const method::hysteresis::BreakAwayRamp& ramp : c.break_away.ramps) {
    EXPECT_TRUE(ramp.broke_away) << ramp.recording;
    EXPECT_NEAR(ramp.friction_Nm, 1.64, 0.22) << ramp.recording;  // 1.43 to 1.82 N·m by hand
  }
  // The sines of 0.8 N·m never slide: nothing above them can be read from them.
  EXPECT_FALSE(c.lugre->shown(LuGreParameterName::coulomb_torque));
  EXPECT_NE(quantity(c, joint::Quantity::bristle_stiffness).verdict, calibration::Verdict::usable);
}

TEST(RealLog, Ur10eRaisesTheEncoderStepAndNothingElse) {
  TRIBOLOG_NEEDS_REAL_LOG("ur10e_jointwise/joint_2.csv");
  for (const char* manifest : {"ur10e_joint_2.toml", "ur10e_joint_3.toml"}) {
    joint::Dataset dataset;
    const calibration::Calibration c = identify_manifest(manifest, dataset);
    EXPECT_EQ(test::findings_of(c.data_checks), std::vector<std::string>{"encoder_step"})
        << manifest;
    for (const joint::Quantity key :
         {joint::Quantity::break_away_torque, joint::Quantity::bristle_stiffness,
          joint::Quantity::bristle_damping}) {
      const calibration::QuantityVerdict& q = quantity(c, key);
      EXPECT_EQ(q.verdict, calibration::Verdict::not_identifiable) << to_string(key);
      EXPECT_NE(wording::words(q.reasons.front()).find("the step of the angle is too coarse"),
                std::string::npos)
          << wording::words(q.reasons.front());
      EXPECT_TRUE(std::any_of(q.reasons.begin(), q.reasons.end(), [](const Statement& reason) {
        return wording::words(reason).find(" steps of 0.0001 rad") != std::string::npos;
      })) << to_string(key);
    }
    // "Pre-sliding takes place inside 6e-4 rad, six steps of the encoder": as a sample every 10 ms
    // shows it.
    EXPECT_LT(*c.data_checks.find(CheckName::encoder_step)->measured, 20) << manifest;
  }
}

TEST(RealLog, CiceseRaisesItsSpeedColumnAndTheLackOfCommonAngles) {
  TRIBOLOG_NEEDS_REAL_LOG("cicese_joint1/presliding/sine_j1_rep1.csv");
  joint::Dataset dataset;
  const calibration::Calibration c = identify_manifest("cicese_joint1.toml", dataset);
  EXPECT_EQ(test::findings_of(c.data_checks),
            (std::vector<std::string>{"speed_noise", "run_common_angles", "oscillation_at_peak"}));
  EXPECT_NE(quantity(c, joint::Quantity::coulomb_torque).verdict, calibration::Verdict::usable);
}

TEST(RealLog, CiceseIsPrintedWithFourDecimalsOfADegree) {
  TRIBOLOG_NEEDS_REAL_LOG("cicese_joint1/presliding/sine_j1_rep1.csv");
  joint::Dataset dataset;
  const calibration::Calibration c = identify_manifest("cicese_joint1.toml", dataset);
  ASSERT_EQ(c.hysteresis.oscillations.size(), 3U);
  for (const method::hysteresis::Oscillation& o : c.hysteresis.oscillations) {
    EXPECT_NEAR(o.encoder_step_rad, 1e-4 * joint::rad_per_degree, 1e-12);
    EXPECT_TRUE(o.step_is_of_print);
  }
  const method::checks::DataCheck* check = c.data_checks.find(CheckName::encoder_step);
  EXPECT_EQ(check->state, method::checks::CheckState::passed);
  EXPECT_NE(wording::words(check->found).find("last decimal of the log"), std::string::npos)
      << wording::words(check->found);
}

TEST(RealLog, PendulumIsRefusedForWantOfTorque) {
  TRIBOLOG_NEEDS_REAL_LOG("bam_xl330_pendulum/up_and_down_kp400.csv");
  for (const char* manifest : {"bam_lift_and_drop.toml", "bam_sin_sin.toml",
                               "bam_sin_time_square.toml", "bam_up_and_down.toml"}) {
    joint::Dataset dataset;
    const calibration::Calibration c = identify_manifest(manifest, dataset);
    EXPECT_EQ(c.judgement.verdict, calibration::Verdict::not_identifiable) << manifest;
    EXPECT_NE(wording::words(c.judgement.sentence).find("No torque was recorded"),
              std::string::npos);
    const calibration::QuantityVerdict& gravity = quantity(c, joint::Quantity::cog_angle);
    EXPECT_NE(wording::words(gravity.reasons.front())
                  .find("actual current together with the torque constant"),
              std::string::npos)
        << wording::words(gravity.reasons.front());
    for (const calibration::QuantityVerdict& q : c.judgement.quantities) {
      EXPECT_EQ(q.verdict, calibration::Verdict::not_identifiable)
          << manifest << ": " << to_string(q.quantity);
      EXPECT_FALSE(q.experiment.empty()) << to_string(q.quantity);
    }
  }
}

TEST(RealLog, PendulumThatOnlyRisesCannotTellCoulombFromOffset) {
  TRIBOLOG_NEEDS_REAL_LOG("bam_xl330_pendulum/up_and_down_kp400.csv");
  joint::Dataset dataset;
  const calibration::Calibration c = identify_manifest("bam_up_and_down.toml", dataset);
  const method::checks::DataCheck* check = c.data_checks.find(CheckName::sweep_directions);
  EXPECT_EQ(check->state, method::checks::CheckState::fails);
  EXPECT_NE(wording::words(check->found).find("only ever rises"), std::string::npos)
      << wording::words(check->found);
  const auto& reasons = quantity(c, joint::Quantity::coulomb_torque).reasons;
  EXPECT_TRUE(std::any_of(reasons.begin(), reasons.end(), [](const Statement& reason) {
    return wording::words(reason).find("Coulomb friction and offset cannot be told apart") !=
           std::string::npos;
  }));
  joint::Dataset other;
  EXPECT_FALSE(
      identify_manifest("bam_sin_sin.toml", other).data_checks.fails(CheckName::sweep_directions));
}

}  // namespace
}  // namespace tribolog::real_log_test
