// The promises on the paper's joint, noise-free: simulate, identify, compare with the truth and
// with what the paper prints.

#include "support/paper_joint.h"

#include <cmath>
#include <utility>

#include <gtest/gtest.h>

#include "identify/identify.h"
#include "wording/words.h"

namespace tribolog::paper_joint_test {
namespace {

using method::hysteresis::Estimator;

class PaperJoint : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    dataset_ = new joint::Dataset(simulate::simulated_dataset(test::paper_joint()));
    calibration_ = new calibration::Calibration(identify::identify(*dataset_));
  }
  static void TearDownTestSuite() {
    delete calibration_;
    delete dataset_;
  }
  static const calibration::Calibration& c() { return *calibration_; }

 private:
  static joint::Dataset* dataset_;
  static calibration::Calibration* calibration_;
};

joint::Dataset* PaperJoint::dataset_ = nullptr;
calibration::Calibration* PaperJoint::calibration_ = nullptr;

TEST_F(PaperJoint, SixMassesWithinHalfAPercentOfTable2) {
  const std::pair<Estimator, double> table_2[] = {{Estimator::A, 79.999}, {Estimator::B, 78.811},
                                                  {Estimator::C, 97.023}, {Estimator::D, 61.009},
                                                  {Estimator::E, 75.494}, {Estimator::F, 82.785}};
  for (const auto& [estimator, mass] : table_2) {
    const method::hysteresis::SurrogateMass* ours = c().masses.find(estimator);
    ASSERT_NE(ours, nullptr) << to_string(estimator);
    EXPECT_NEAR(ours->mass_kg.value / mass, 1, 0.005) << to_string(estimator);
  }
}

TEST_F(PaperJoint, ThePaperSelectsB) {
  EXPECT_EQ(c().selection.paper_rule, Estimator::B);
  EXPECT_TRUE(c().selection.paper_rule_rivals.empty());
}

TEST_F(PaperJoint, ModelAndMidlineGiveTheTrueMass) {
  EXPECT_EQ(c().selection.recommended, Estimator::model);
  for (const Estimator estimator : {Estimator::model, Estimator::midline}) {
    EXPECT_NEAR(c().masses.find(estimator)->mass_kg.value / test::true_surrogate_mass_kg, 1, 1e-4)
        << to_string(estimator);
  }
}

TEST_F(PaperJoint, AnglesOfTheCentreOfGravity) {
  EXPECT_NEAR(c().precise.q_peak_rad.value, test::true_q_peak_rad(), 1e-7);
  EXPECT_NEAR(c().rough.q_peak_rad.value, test::true_q_peak_rad(), 1e-4);
  EXPECT_NEAR(c().rough.argmax_rad, test::true_q_peak_rad(), 1e-4);
  EXPECT_NEAR(c().selection.q_c_rad->value, 0.388019, 1e-6);
}

TEST_F(PaperJoint, CorrectedAngleIsTheAngleAtThePointChosen) {
  // Eq. (14): q_c less the micro-angle at which B was read.
  const method::hysteresis::LoopPoint& b = c().hysteresis.points[1];
  ASSERT_TRUE(c().selection.q_c_corrected_rad);
  EXPECT_NEAR(*c().selection.q_c_corrected_rad, -b.q_rad, 1e-12);
  EXPECT_GT(c().selection.q_c_rad->value - *c().selection.q_c_corrected_rad, 0);
  EXPECT_LT(c().selection.q_c_rad->value - *c().selection.q_c_corrected_rad, 1e-4);
}

TEST_F(PaperJoint, ViscousParametersComeBack) {
  ASSERT_TRUE(c().friction.waiboer);
  EXPECT_NEAR(c().friction.waiboer->asperity_torque_Nm.value, 0.8844, 1e-3);
  EXPECT_NEAR(c().friction.waiboer->stribeck_speed_rad_s.value, 5, 1e-2);
  EXPECT_NEAR(c().friction.waiboer->viscous_power.value, 0.6, 1e-3);
}

TEST_F(PaperJoint, EveryStageIsDoneAndTheVerdictIsUsable) {
  for (const statistics::StageReport& stage : c().stages()) {
    EXPECT_EQ(stage.state, statistics::StageState::done)
        << stage.name << ": " << wording::words(stage.reason);
  }
  EXPECT_EQ(c().judgement.verdict, calibration::Verdict::usable);
}

TEST_F(PaperJoint, EveryIntervalHoldsItsEstimate) {
  for (const method::hysteresis::SurrogateMass& m : c().masses.masses) {
    EXPECT_LE(m.mass_kg.low, m.mass_kg.value);
    EXPECT_GE(m.mass_kg.high, m.mass_kg.value);
  }
}

}  // namespace
}  // namespace tribolog::paper_joint_test
