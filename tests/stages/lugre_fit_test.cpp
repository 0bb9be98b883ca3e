#include "stages/lugre_fit.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Core>
#include <gtest/gtest.h>

#include "stages/lugre_loop_model.h"
#include "support/paper_joint.h"

namespace tribolog {
namespace {

Recording oscillation_of(const Scenario& scenario) {
  Scenario s = scenario;
  s.rough_sweep.reset();
  s.precise_sweep.reset();
  s.constant_speed.reset();
  return test::simulated_dataset(s).recordings.front();
}

LuGreFit fit(const Recording& r) {
  return fit_lugre(r, *fit_oscillation_motion(r), 100, test::true_q_peak_rad());
}

TEST(LuGreLoopModel, DerivativesAgreeWithDifferences) {
  const Recording r = oscillation_of(test::paper_joint());
  const auto motion = fit_oscillation_motion(r);
  const LuGreLoopModel model(r, *motion, 100, test::true_q_peak_rad());
  LuGreLoopModel::Vector p;
  p << std::log(400), std::log(0.8), 0.6, 0.05, 3.8, 1e-3, 2e-4;
  Eigen::VectorXd residuals;
  Eigen::MatrixXd jacobian;
  model.evaluate(p, residuals, &jacobian);
  for (int k = 0; k < LuGreLoopModel::parameters; ++k) {
    const double h = k == LuGreLoopModel::start_deflection ? 1e-9 : 1e-6;
    LuGreLoopModel::Vector up = p;
    LuGreLoopModel::Vector down = p;
    up(k) += h;
    down(k) -= h;
    Eigen::VectorXd above;
    Eigen::VectorXd below;
    model.evaluate(up, above, nullptr);
    model.evaluate(down, below, nullptr);
    const Eigen::VectorXd difference = (above - below) / (2 * h);
    const double scale = jacobian.col(k).cwiseAbs().maxCoeff();
    EXPECT_LT((difference - jacobian.col(k)).cwiseAbs().maxCoeff(), 1e-5 * scale) << k;
  }
}

TEST(LuGreFit, RecoversTheJointFromItsTorqueAlone) {
  Scenario s = test::paper_joint();
  s.presliding = std::make_shared<LuGreFriction>(
      LuGreFriction::Parameters{465.42, 0.77080, 0.05, 0.88437633, 0.88437633, 5.0});
  const LuGreFit f = fit(oscillation_of(s));
  ASSERT_TRUE(f.converged) << f.reason;
  EXPECT_NEAR(f.bristle_stiffness_Nm_rad.value, 465.42, 1e-4 * 465.42);
  EXPECT_NEAR(f.static_Nm.value, 0.88437633, 1e-5);
  EXPECT_NEAR(f.bristle_damping_Nms_rad.value, 0.7708, 1e-3);
  EXPECT_NEAR(f.viscous_Nms_rad.value, 0.05, 1e-3);
  EXPECT_NEAR(f.gravity_Nm.value, test::true_gravity_Nm, 1e-6);
  EXPECT_NEAR(f.inertia_kgm2.value, s.motor_inertia_kgm2 + s.arm_inertia_kgm2 / 1e4, 1e-5);
  EXPECT_LT(f.residual_Nm, 1e-5);
}

TEST(LuGreFit, ObservesTheBristleThatTheLogDoesNotHold) {
  const Recording with = oscillation_of(test::paper_joint());
  const LuGreFit f = fit(with);
  ASSERT_TRUE(f.converged);
  double largest = 0;
  double worst = 0;
  for (std::size_t i = 0; i < with.size(); ++i) {
    largest = std::max(largest, std::abs(with.z_rad[i]));
    worst = std::max(worst, std::abs(with.z_rad[i] - f.z_rad[i]));
  }
  EXPECT_LT(worst, 0.005 * largest);
}

TEST(LuGreFit, HoldsUpInTheNoiseOfARealDrive) {
  const LuGreFit f = fit(oscillation_of(test::noisy_paper_joint(4)));
  ASSERT_TRUE(f.converged);
  EXPECT_NEAR(f.gravity_Nm.value, test::true_gravity_Nm, 1e-3 * test::true_gravity_Nm);
  EXPECT_NEAR(f.bristle_stiffness_Nm_rad.value, 465.42, 0.05 * 465.42);
  EXPECT_NEAR(f.static_Nm.value, 0.884, 0.01);
  EXPECT_NEAR(f.residual_Nm, 0.02, 0.002);
}

TEST(LuGreFit, SaysWhatTheLoopCannotShow) {
  const LuGreFit f = fit(oscillation_of(test::paper_joint()));
  EXPECT_NE(f.reason.find("Stribeck velocity do not show"), std::string::npos);
}

}  // namespace
}  // namespace tribolog
