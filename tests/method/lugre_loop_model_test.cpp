#include "method/hysteresis/lugre_loop_model.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "friction/dual.h"
#include "support/cvode_bristle.h"
#include "support/paper_joint.h"

namespace tribolog::lugre_loop_model_test {
namespace {

using Shared = method::hysteresis::LuGreShared;

struct Loop {
  joint::Recording recording;
  std::shared_ptr<const simulate::HarmonicMotion> motion;
};

/// 3.3 cycles of a motor sine, 1 kHz.
Loop loop_of(double motor_amplitude_rad, double frequency_Hz) {
  Loop out;
  out.motion = std::make_shared<simulate::HarmonicMotion>(simulate::HarmonicMotion::sine(
      100 * test::true_q_peak_rad(), motor_amplitude_rad, frequency_Hz));
  for (int i = 0; i < 3300 / frequency_Hz; ++i) {
    out.recording.t_s.push_back(1e-3 * i);
    out.recording.q_rad.push_back(out.motion->angle(1e-3 * i) / 100);
    out.recording.torque_Nm.push_back(3.9);
  }
  return out;
}

Shared::Vector shared_of(const friction::LuGreFriction::Parameters& p) {
  Shared::Vector v;
  v << std::log(p.bristle_stiffness_Nm_rad), std::log(p.static_Nm),
      std::log(p.coulomb_Nm / p.static_Nm), std::pow(p.stribeck_speed_rad_s, -2),
      p.bristle_damping_Nms_rad, p.viscous_Nms_rad, 2e-3;
  return v;
}

TEST(LuGreLoopModel, ARowOfSeveralSamplesIsTheMeanOfTheirs) {
  const Loop loop = loop_of(0.3, 1.0);
  const double q_peak = test::true_q_peak_rad();
  const method::hysteresis::LuGreLoopModel each(loop.recording, loop.motion, 100, q_peak);
  const method::hysteresis::LuGreLoopModel together(loop.recording, loop.motion, 100, q_peak,
                                                    {1, 7});
  const Shared::Vector p = shared_of({400, 0.6, 0.05, 0.5, 0.8, 4.0});
  const method::hysteresis::LuGreLocal local{3.8, 1e-3};
  Eigen::VectorXd fine;
  Eigen::VectorXd coarse;
  method::hysteresis::LuGreLoopModel::Rows fine_rows;
  method::hysteresis::LuGreLoopModel::Rows coarse_rows;
  each.evaluate(p, local, true, fine, fine_rows);
  together.evaluate(p, local, true, coarse, coarse_rows);
  ASSERT_EQ(together.rows(), (each.rows() + 6) / 7);
  ASSERT_EQ(coarse.size(), together.rows());
  const double height = fine.maxCoeff() - fine.minCoeff();
  for (Eigen::Index row = 0; row < coarse.size(); ++row) {
    const Eigen::Index count = std::min<Eigen::Index>(7, fine.size() - 7 * row);
    EXPECT_NEAR(coarse(row), fine.segment(7 * row, count).mean(), 1e-5 * height) << row;
    const Eigen::RowVectorXd mean = fine_rows.middleRows(7 * row, count).colwise().mean();
    for (int k = 0; k < method::hysteresis::LuGreLoopModel::columns; ++k) {
      const double size = fine_rows.col(k).cwiseAbs().maxCoeff();
      EXPECT_NEAR(coarse_rows(row, k), mean(k), 1e-4 * size) << row << ' ' << k;
    }
  }
}

class DerivativesOfTheLoop : public testing::TestWithParam<double> {};

// From micro-speed to three times the Stribeck velocity.
INSTANTIATE_TEST_SUITE_P(Amplitudes, DerivativesOfTheLoop, testing::Values(0.01, 0.3, 2.5));

TEST_P(DerivativesOfTheLoop, AgreeWithCentralDifferences) {
  const Loop loop = loop_of(GetParam(), 1.0);
  const method::hysteresis::LuGreLoopModel model(loop.recording, loop.motion, 100,
                                                 test::true_q_peak_rad());
  const Shared::Vector p = shared_of({400, 0.6, 0.05, 0.5, 0.8, 4.0});
  const method::hysteresis::LuGreLocal local{3.8, 1e-3};
  Eigen::VectorXd residuals;
  method::hysteresis::LuGreLoopModel::Rows derivatives;
  model.evaluate(p, local, true, residuals, derivatives);
  for (int k = 0; k < method::hysteresis::LuGreLoopModel::columns; ++k) {
    Shared::Vector shared[2] = {p, p};
    method::hysteresis::LuGreLocal locals[2] = {local, local};
    const double h = k == 1 ? 1e-8 : 1e-5;
    for (const int side : {0, 1}) {
      const double step = side == 0 ? -h : h;
      if (k == 0) locals[side].gravity_Nm += step;
      if (k == 1) locals[side].start_rad += step;
      if (k > 1) shared[side](k - 2) += step;
    }
    Eigen::VectorXd sides[2];
    method::hysteresis::LuGreLoopModel::Rows unused;
    for (const int side : {0, 1}) {
      model.evaluate(shared[side], locals[side], true, sides[side], unused);
    }
    const Eigen::VectorXd difference = (sides[1] - sides[0]) / (2 * h);
    const double scale = derivatives.col(k).cwiseAbs().maxCoeff();
    // The difference quotient's own error is of the second order in h.
    EXPECT_LT((difference - derivatives.col(k)).cwiseAbs().maxCoeff(), 2e-6 * scale + 1e-9) << k;
  }
}

TEST_P(DerivativesOfTheLoop, BristleIsThatOfAnIndependentSolver) {
  const double frequency = 1.0;
  const Loop loop = loop_of(GetParam(), frequency);
  const method::hysteresis::LuGreLoopModel model(loop.recording, loop.motion, 100,
                                                 test::true_q_peak_rad());
  const friction::LuGreFriction::Parameters p{465.42, 0.7708, 0.001, 0.6, 0.88437633, 5.0};
  std::vector<double> z;
  std::vector<double> dz;
  model.bristle(shared_of(p), 0, z, dz);
  std::vector<double> solved(loop.recording.size());
  test::CvodeOptions options;
  options.reversals_s = test::sine_reversals(frequency, 4);
  const auto motor = simulate::HarmonicMotion::sine(0, GetParam(), frequency);
  test::solve_bristle_with_cvode(friction::LuGreFriction(p), motor, 1e-3, options, solved);
  double worst = 0;
  for (std::size_t i = 0; i < z.size(); ++i) worst = std::max(worst, std::abs(z[i] - solved[i]));
  // CVODE runs at 1e-12; the exponential step is of the 4th order at 1 ms.
  EXPECT_LT(worst, 1e-6 * p.static_Nm / p.bristle_stiffness_Nm_rad);
}

TEST(LuGreLoopModel, MicroSpeedIsTheLimitOfNoFall) {
  const Loop loop = loop_of(0.01, 1.0);
  const method::hysteresis::LuGreLoopModel model(loop.recording, loop.motion, 100,
                                                 test::true_q_peak_rad());
  Shared::Vector p = shared_of({400, 0.6, 0.05, 0.5, 0.8, 4.0});
  p(Shared::fall) = 0;
  Eigen::VectorXd with;
  Eigen::VectorXd without;
  method::hysteresis::LuGreLoopModel::Rows derivatives_with;
  method::hysteresis::LuGreLoopModel::Rows derivatives_without;
  model.evaluate(p, {3.8, 0}, true, with, derivatives_with);
  model.evaluate(p, {3.8, 0}, false, without, derivatives_without);
  EXPECT_LT((with - without).cwiseAbs().maxCoeff(), 1e-14);
  for (int k = 0; k < method::hysteresis::LuGreLoopModel::columns; ++k) {
    const bool held = k == 2 + Shared::log_share || k == 2 + Shared::fall;
    if (held) {
      EXPECT_EQ(derivatives_without.col(k).norm(), 0) << k;
    } else {
      EXPECT_LT((derivatives_with.col(k) - derivatives_without.col(k)).cwiseAbs().maxCoeff(), 1e-12)
          << k;
    }
  }
  EXPECT_GT(derivatives_with.col(2 + Shared::fall).norm(), 0) << "it shows even where it is zero";
}

TEST(Dual, FollowsTheRulesOfDifferentiation) {
  using D = friction::Dual<2>;
  const D x = D::parameter(0.7, 0);
  const D y = D::parameter(2.5, 1);
  const D f = (x * y - 3.0) / (x + 1.0) + 2.0 / y - friction::exp_nonpositive(-x);
  const auto plain = [](double a, double b) {
    return (a * b - 3) / (1 + a) + 2 / b - std::exp(-a);
  };
  constexpr double h = 1e-6;
  EXPECT_NEAR(f.value, plain(0.7, 2.5), 1e-15);
  EXPECT_NEAR(f.by[0], (plain(0.7 + h, 2.5) - plain(0.7 - h, 2.5)) / (2 * h), 1e-9);
  EXPECT_NEAR(f.by[1], (plain(0.7, 2.5 + h) - plain(0.7, 2.5 - h)) / (2 * h), 1e-9);
}

}  // namespace
}  // namespace tribolog::lugre_loop_model_test
