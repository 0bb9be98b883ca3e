// LuGre from loops of a joint that a torque drives: growing, not periodic, of a motion that is the
// answer and not the plan.

#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>
#include <numbers>

#include <gtest/gtest.h>

#include "base/parallel_for.h"
#include "method/hysteresis/hysteresis_loop.h"
#include "simulate/drive_noise.h"
#include "support/loop_fit.h"
#include "support/paper_joint.h"
#include "support/torque_driven_loop.h"
#include "wording/words.h"

namespace tribolog::torque_driven_lugre_test {
namespace {

using method::hysteresis::LoopMotion;
using method::hysteresis::LuGreParameterName;

constexpr double duration_s = 8;
constexpr double rate_Hz = 1000;

double error_of(const method::hysteresis::LuGreFit& f, LuGreParameterName name) {
  const auto e = f.shown(name);
  return e ? std::abs(e->value / test::true_parameters(test::paper_joint()).at(name) - 1)
           : INFINITY;
}

std::vector<joint::Recording> clean_loops() {
  std::vector<joint::Recording> loops;
  for (const test::DrivingTorque& torque : {test::growing_sine(0.3, 0.8, 0.5, duration_s),
                                            test::growing_triangle(0.3, 0.8, 0.5, duration_s),
                                            test::growing_sine(0.2, 0.7, 0.6, duration_s),
                                            test::growing_triangle(0.5, 0.82, 0.75, duration_s)}) {
    loops.push_back(test::torque_driven_loop(test::paper_joint(), torque, duration_s, rate_Hz));
  }
  return loops;
}

TEST(TorqueDrivenLuGre, CleanLoopsGiveStiffnessLevelAndGravity) {
  for (const joint::Recording& loop : clean_loops()) {
    const method::hysteresis::LuGreFit f = test::fit_traced({loop});
    ASSERT_TRUE(f.converged) << wording::words(f.reason);
    EXPECT_LT(error_of(f, LuGreParameterName::bristle_stiffness), 1e-4);
    EXPECT_LT(error_of(f, LuGreParameterName::static_torque), 1e-4);
    ASSERT_TRUE(f.gravity_Nm);
    EXPECT_NEAR(f.gravity_Nm->value / test::true_gravity_Nm, 1, 1e-5);
    EXPECT_EQ(f.loops.front().motion, LoopMotion::spline);
    EXPECT_EQ(wording::words(f.reason).find("does not follow LuGre"), std::string::npos)
        << wording::words(f.reason);
    ASSERT_TRUE(f.loops.front().traced->turn_stiffness_Nm_rad);
    EXPECT_NEAR(f.loops.front().traced->turn_stiffness_Nm_rad->value /
                    f.loops.front().traced->model_turn_stiffness_Nm_rad->value,
                1, 1e-3);
  }
}

TEST(TorqueDrivenLuGre, ARecordingMayBeginAnywhereInALoop) {
  joint::Recording loop = clean_loops().front();
  for (std::vector<double>* signal : {&loop.t_s, &loop.q_rad, &loop.torque_Nm}) {
    signal->erase(signal->begin(), signal->begin() + 3300);
  }
  const method::hysteresis::LuGreFit f = test::fit_traced({loop});
  EXPECT_LT(error_of(f, LuGreParameterName::bristle_stiffness), 1e-3);
  EXPECT_NEAR(f.gravity_Nm->value / test::true_gravity_Nm, 1, 1e-3);
  EXPECT_GT(std::abs(f.loops.front().start_deflection_rad), 1e-5);
}

TEST(TorqueDrivenLuGre, SmallLoopsSayThatSlidingIsNotReached) {
  const joint::Recording loop = test::torque_driven_loop(
      test::paper_joint(), test::growing_sine(0.1, 0.25, 0.5, duration_s), duration_s, rate_Hz);
  const method::hysteresis::LuGreFit f = test::fit_traced({loop});
  EXPECT_LT(error_of(f, LuGreParameterName::bristle_stiffness), 1e-3);
  EXPECT_NE(wording::words(f.reason).find("of the way to sliding"), std::string::npos)
      << wording::words(f.reason);
  EXPECT_FALSE(f.shown(LuGreParameterName::coulomb_torque));
}

TEST(TorqueDrivenLuGre, TheStageTakesTheSplineAndLeavesHarmonicsToSines) {
  const std::vector<joint::Recording> loops = clean_loops();
  const std::vector<joint::Recording> sine = test::oscillations_of(test::noisy_paper_joint(1));
  const method::gravity::CogSweepResult no_sweep;
  const statistics::Estimate peak = statistics::symmetric_estimate(test::true_q_peak_rad(), 0);
  const method::hysteresis::Hysteresis made =
      method::hysteresis::identify_hysteresis({&loops[0], &sine[0]}, {}, no_sweep, 100, peak);
  const method::hysteresis::HysteresisResult& h = made.result;
  ASSERT_TRUE(h.found) << wording::words(h.stage.reason);
  ASSERT_TRUE(made.lugre && made.lugre->fit.converged);
  ASSERT_EQ(made.lugre->fit.loops.size(), 2U);
  EXPECT_EQ(made.lugre->fit.loops[0].motion, LoopMotion::spline);
  EXPECT_EQ(made.lugre->fit.loops[1].motion, LoopMotion::harmonics);
  EXPECT_LT(error_of(made.lugre->fit, LuGreParameterName::bristle_stiffness), 0.02);
}

TEST(TorqueDrivenLuGre, OtherFrictionIsToldFromLuGre) {
  // Stiffness that falls with the torque more than LuGre's does: the angle of a hardening spring.
  joint::Recording loop = clean_loops().front();
  const double centre = test::true_q_peak_rad();
  for (double& q : loop.q_rad) q += 3e5 * std::pow(q - centre, 2);
  const method::hysteresis::LuGreFit f = test::fit_traced({loop});
  EXPECT_NE(wording::words(f.reason).find("does not follow LuGre"), std::string::npos)
      << wording::words(f.reason);
}

TEST(TorqueDrivenLuGre, IntervalsHoldInTheNoiseOfADrive) {
  // White noise of the torque and an encoder whose step is a hundredth of the loop's width.
  constexpr std::size_t seeds = 100;
  constexpr std::array<LuGreParameterName, 2> names{LuGreParameterName::bristle_stiffness,
                                                    LuGreParameterName::static_torque};
  const std::vector<joint::Recording> clean = clean_loops();
  const auto truth = test::true_parameters(test::paper_joint());
  std::array<int, 2> covered{};
  int gravity = 0;
  int misfits = 0;
  std::mutex guard;
  parallel_for(seeds, [&](std::size_t k) {
    joint::Recording r = clean[k % clean.size()];
    simulate::Noise noise;
    noise.torque_white_Nm = 0.02;
    noise.encoder_counts_per_turn = 131072;
    noise.seed = k + 1;
    const double step = 2 * std::numbers::pi / noise.encoder_counts_per_turn / 100;
    // The encoder's phase is another one each time.
    for (double& q : r.q_rad) q += step * std::fmod(0.618034 * static_cast<double>(k), 1.0);
    simulate::add_drive_noise(r, noise, 100, rate_Hz, 1);
    const method::hysteresis::LuGreFit f = test::fit_traced({r});
    const std::lock_guard lock(guard);
    for (std::size_t i = 0; i < names.size(); ++i) {
      const auto e = f.shown(names[i]);
      covered[i] += e && e->low <= truth.at(names[i]) && truth.at(names[i]) <= e->high ? 1 : 0;
    }
    const auto& g = f.gravity_Nm;
    gravity += g && g->low <= test::true_gravity_Nm && test::true_gravity_Nm <= g->high ? 1 : 0;
    misfits += wording::words(f.reason).find("does not follow LuGre") == std::string::npos ? 0 : 1;
  });
  RecordProperty("stiffness", covered[0]);
  RecordProperty("static", covered[1]);
  RecordProperty("gravity", gravity);
  EXPECT_GE(covered[0], 91);
  EXPECT_LE(covered[0], 99);
  // Every turn is smoothed alike, which makes the level a little too high: fewer hold it.
  EXPECT_GE(covered[1], 85);
  EXPECT_GE(gravity, 91);
  EXPECT_EQ(misfits, 0);
}

}  // namespace
}  // namespace tribolog::torque_driven_lugre_test
