// Parts of the checks on data whose answer is known beforehand.

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "method/checks/check_list.h"
#include "method/checks/direction_difference.h"
#include "method/checks/scale_causes.h"
#include "method/gravity/cog_sweep.h"
#include "support/paper_joint.h"

namespace tribolog::data_checks_test {
namespace {

using std::numbers::pi;

TEST(Strokes, OfASineAreItsHalvesAndNoiseMakesNoMore) {
  std::vector<double> clean;
  std::vector<double> noisy;
  for (int i = 0; i <= 4000; ++i) {
    const double q = std::sin(2 * pi * i / 1000.0);
    clean.push_back(q);
    noisy.push_back(q + 0.02 * std::sin(1.7 * i));
  }
  for (const auto& q : {clean, noisy}) {
    const auto strokes = method::motion::find_strokes(q, 0.1);
    // Up to the first crest, seven halves, and back to the middle.
    ASSERT_EQ(strokes.size(), 9U);
    EXPECT_EQ(strokes.front().direction, 1.0);
    for (std::size_t k = 1; k + 1 < strokes.size(); ++k) {
      EXPECT_NEAR(strokes[k].travel_rad, 2, 0.05);
      EXPECT_EQ(strokes[k].first, strokes[k - 1].last);
      EXPECT_EQ(strokes[k].direction, -strokes[k - 1].direction);
    }
  }
}

TEST(Strokes, OfRestAreNone) {
  EXPECT_TRUE(method::motion::find_strokes(std::vector<double>(100, 0.3), 1e-6).empty());
  EXPECT_TRUE(method::motion::find_strokes({}, 1e-6).empty());
}

/// The noisy paper joint's log with something done to it, as one of the checks sees it.
template <typename Change>
method::checks::DataCheck checked(
    method::checks::DataCheck (*check)(const method::checks::CheckedDataset&), Change change) {
  joint::Dataset d = simulate::simulated_dataset(test::noisy_paper_joint(2));
  change(d);
  return check(method::checks::look_at(d));
}

TEST(AngleChecks, AJumpThatStaysIsFoundAndTheMotionOfAJointIsNone) {
  using method::checks::CheckState;
  const auto jump = [](double degrees) {
    return [degrees](joint::Dataset& d) {
      for (joint::Recording& r : d.recordings) {
        if (r.role != joint::Role::rough_sweep) continue;
        for (std::size_t i = r.size() / 3; i < r.size(); ++i) r.q_rad[i] += degrees * pi / 180;
      }
    };
  };
  const auto check = method::checks::check_angle_jumps;
  EXPECT_EQ(checked(check, jump(0)).state, CheckState::passed);
  const method::checks::DataCheck found = checked(check, jump(-0.3));
  EXPECT_EQ(found.state, CheckState::fails);
  EXPECT_NEAR(*found.measured, 0.3 * pi / 180, 1e-3);
}

TEST(AngleChecks, AJumpOfAFewSamplesMotionIsFoundAndARowLostUnderASteadyClockIsNone) {
  using method::checks::CheckState;
  // The sweep turns 0.002 degrees from sample to sample.
  const auto further = [](double samples) {
    return [samples](joint::Dataset& d) {
      for (joint::Recording& r : d.recordings) {
        if (r.role != joint::Role::rough_sweep) continue;
        const std::size_t at = r.size() / 3;
        const double step = (r.q_rad[at + 100] - r.q_rad[at]) / 100;
        for (std::size_t i = at; i < r.size(); ++i) r.q_rad[i] += samples * step;
      }
    };
  };
  const auto check = method::checks::check_angle_jumps;
  for (const double lost : {1., 2.}) {
    EXPECT_EQ(checked(check, further(lost)).state, CheckState::passed) << lost;
  }
  for (const double jump : {-50., -20., 20., 50.}) {
    EXPECT_EQ(checked(check, further(jump)).state, CheckState::fails) << jump;
  }
}

TEST(AngleChecks, AMotorThatWouldTurnAbsurdlyFastIsFound) {
  using method::checks::CheckState;
  const auto at_ratio = [](double ratio) {
    return [ratio](joint::Dataset& d) {
      for (joint::Recording& r : d.recordings) {
        for (double& q : r.q_rad) q *= ratio;
      }
    };
  };
  const auto check = method::checks::check_motor_speed;
  EXPECT_EQ(checked(check, at_ratio(1)).state, CheckState::passed);
  EXPECT_EQ(checked(check, at_ratio(100)).state, CheckState::fails);
}

TEST(AngleChecks, AnAngleHeldForSomeSamplesIsOfASlowerChannel) {
  using method::checks::CheckState;
  const auto held = [](std::size_t samples) {
    return [samples](joint::Dataset& d) {
      for (joint::Recording& r : d.recordings) {
        if (r.role != joint::Role::oscillation) continue;
        for (std::size_t i = 0; i < r.size(); ++i) r.q_rad[i] = r.q_rad[i - i % samples];
      }
    };
  };
  const auto check = method::checks::check_angle_interpolated;
  EXPECT_EQ(checked(check, held(1)).state, CheckState::passed);
  const method::checks::DataCheck found = checked(check, held(5));
  EXPECT_EQ(found.state, CheckState::fails);
  EXPECT_EQ(found.measured, 5);
}

TEST(TorqueChecks, ATorqueIsHeldWhereTheJointMovesAndNotWhereItsEncoderFlickers) {
  using method::checks::CheckState;
  // The sweep's torque stands for 60 samples at a time, of a joint that moves on or stays where it
  // is but for the encoder's last step.
  const auto held = [](bool joint_moves) {
    return [joint_moves](joint::Dataset& d) {
      for (joint::Recording& r : d.recordings) {
        if (r.role != joint::Role::rough_sweep) continue;
        for (std::size_t i = 300; i + 60 < r.size(); i += 300) {
          for (std::size_t k = i; k < i + 60; ++k) r.torque_Nm[k] = r.torque_Nm[i - 1];
          if (joint_moves) continue;
          const double step_rad = 2 * pi / 131072 / d.manifest.drive.gear_ratio();
          for (std::size_t k = i - 20; k < i + 80; ++k) {
            r.q_rad[k] = r.q_rad[i - 21] + (k % 7 == 0 ? step_rad : 0);
          }
        }
      }
    };
  };
  const auto check = method::checks::check_torque_held;
  EXPECT_EQ(checked(check, held(true)).state, CheckState::fails);
  EXPECT_EQ(checked(check, held(false)).state, CheckState::passed);
}

TEST(TorqueChecks, ATorqueSampledMoreSlowlyThanItIsLoggedIsFound) {
  using method::checks::CheckState;
  const auto sampled_each = [](std::size_t samples, bool held) {
    return [samples, held](joint::Dataset& d) {
      for (joint::Recording& r : d.recordings) {
        const std::vector<double> torque = r.torque_Nm;
        for (std::size_t i = 0; i < r.size(); ++i) {
          const std::size_t at = i - i % samples;
          const std::size_t next = std::min(at + samples, r.size() - 1);
          const double share =
              held ? 0.0 : static_cast<double>(i % samples) / static_cast<double>(samples);
          r.torque_Nm[i] = torque[at] + share * (torque[next] - torque[at]);
        }
      }
    };
  };
  const auto check = method::checks::check_torque_interpolated;
  for (const bool held : {true, false}) {
    EXPECT_EQ(checked(check, sampled_each(1, held)).state, CheckState::passed);
    EXPECT_EQ(checked(check, sampled_each(3, held)).state, CheckState::warns) << held;
    const method::checks::DataCheck found = checked(check, sampled_each(10, held));
    EXPECT_EQ(found.state, CheckState::fails) << held;
    EXPECT_EQ(found.measured, 10) << held;
  }
  // The bends of a triangle are all alike: it is a command.
  const auto triangle = [](joint::Dataset& d) {
    for (joint::Recording& r : d.recordings) {
      for (std::size_t i = 0; i < r.size(); ++i) {
        r.torque_Nm[i] = std::abs(static_cast<double>(i % 40) - 20);
      }
    }
  };
  EXPECT_EQ(checked(check, triangle).state, CheckState::passed);
}

TEST(ScaleCauses, AreNamedWithinTheUncertaintyOfTheFactor) {
  const auto names = [](double factor, const char* word) {
    return wording::words(method::checks::likely_cause_of_scale(factor, 1e-3, 100)).find(word) !=
           std::string::npos;
  };
  EXPECT_TRUE(names(2.001, "two samples"));
  EXPECT_TRUE(names(1.667, "6 ms for 10 ms"));
  EXPECT_TRUE(names(57.3, "degrees"));
  EXPECT_TRUE(names(0.01745, "radians per second taken for degrees"));
  EXPECT_TRUE(names(100, "gear ratio"));
  EXPECT_TRUE(names(0.01, "one over the gear"));
  EXPECT_TRUE(names(0.10472, "revolutions"));
  EXPECT_TRUE(names(-1, "sign"));
  EXPECT_TRUE(names(-2, "sign") && names(-2, "two samples"));
  EXPECT_TRUE(names(0, "dead"));
  EXPECT_TRUE(names(1.37, "no common cause"));
  // Two causes that the data cannot tell apart are both named.
  const std::string both = wording::words(method::checks::likely_cause_of_scale(9.55, 0.01, 9.55));
  EXPECT_NE(both.find("gear ratio"), std::string::npos) << both;
  EXPECT_NE(both.find("revolutions"), std::string::npos) << both;
}

TEST(DirectionDifference, IsFrictionWhateverGravityIs) {
  // T = 3 cos q + 0.4 sgn(q'), there and back over different parts of the range.
  joint::Dataset d;
  d.manifest.drive = joint::Drive(1, joint::EffortKind::motor_torque, joint::Side::motor);
  joint::Recording r;
  r.name = "there and back";
  r.role = joint::Role::rough_sweep;
  for (int i = 0; i <= 2000; ++i) {
    const bool up = i <= 1000;
    const double q = up ? -1 + 0.002 * i : 1 - 0.0015 * (i - 1000);
    r.t_s.push_back(0.01 * i);
    r.q_rad.push_back(q);
    r.torque_Nm.push_back(3 * std::cos(q) + (up ? 0.4 : -0.4));
  }
  d.recordings.push_back(r);
  const method::checks::CheckedDataset data = method::checks::look_at(d);
  const method::checks::DirectionDifference both =
      method::checks::direction_difference(data.with_role(joint::Role::rough_sweep), true);
  EXPECT_NEAR(both.friction_Nm, 0.4, 1e-3);  // bins of the angle hold slightly other samples
  EXPECT_NEAR(both.common_share, 1, 1e-9);
  EXPECT_NEAR(both.rising_travel_rad, 2, 1e-9);
  EXPECT_NEAR(both.falling_travel_rad, 1.5, 1e-9);
}

TEST(TorqueRipple, IsFoundAtItsPeriodsAndAmplitudes) {
  simulate::Scenario s = test::noisy_paper_joint(3);
  s.precise_sweep.reset();
  s.oscillation.reset();
  s.constant_speed.reset();
  s.noise.ripple = {{0.03, 2, 0.4}, {0.015, 7, 1.1}};
  const joint::Dataset d = simulate::simulated_dataset(s);
  const method::gravity::CogSweepResult sweep =
      method::gravity::identify_cog_sweep(
          method::gravity::SweepKind::rough,
          method::motion::Sweep(d.with_role(joint::Role::rough_sweep)), s.gear_ratio)
          .result;
  const std::vector<method::gravity::RippleLine>& lines = sweep.ripple.lines;
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_NEAR(lines[0].periods_per_turn, 2, 0.01);
  EXPECT_NEAR(lines[0].amplitude_Nm, 0.03, 0.001);
  EXPECT_NEAR(lines[1].periods_per_turn, 7, 0.01);
  EXPECT_NEAR(lines[1].amplitude_Nm, 0.015, 0.001);
}

TEST(Saturation, IsNotTheTopOfACosineNorCoarseSteps) {
  simulate::Scenario s = test::noisy_paper_joint(1);
  s.noise.torque_white_Nm = 0;
  s.noise.torque_step_Nm = 0.05;  // the top of the cosine lies flat on one step for seconds
  const joint::Dataset d = simulate::simulated_dataset(s);
  EXPECT_EQ(method::checks::check_torque_saturation(method::checks::look_at(d)).state,
            method::checks::CheckState::passed);
}

// Of many runs one ends in three samples of the same largest torque: steps of the log, by chance.
TEST(Saturation, IsNoSingleShortStretchAtTheLargestTorque) {
  simulate::Scenario s = test::paper_joint();
  s.rough_sweep.reset();
  s.precise_sweep.reset();
  s.oscillation.reset();
  std::vector<joint::Recording> runs = simulate::simulate_joint(s);
  joint::Recording& run = runs.front();
  std::vector<double>& torque = run.torque_Nm;
  const auto state_with = [&](std::size_t samples) {
    const std::size_t middle = run.size() / 2;
    const double top = *std::max_element(torque.begin(), torque.end()) + 0.05;
    std::fill_n(torque.begin() + static_cast<std::ptrdiff_t>(middle), samples, top);
    joint::Dataset d;
    d.recordings = {run};
    return method::checks::check_torque_saturation(method::checks::look_at(d)).state;
  };
  torque.resize(400);
  for (auto* signal : {&run.t_s, &run.q_rad, &run.dq_rad_s}) signal->resize(400);
  EXPECT_EQ(state_with(3), method::checks::CheckState::passed);
  EXPECT_EQ(state_with(8), method::checks::CheckState::fails);
}

TEST(Saturation, IsSeenBelowNoiseInRunsWhoseLargestTorquesAreTheSame) {
  simulate::Scenario s = test::noisy_paper_joint(2);
  const auto state = [&] {
    const joint::Dataset d = simulate::simulated_dataset(s);
    return method::checks::check_torque_saturation(method::checks::look_at(d)).state;
  };
  EXPECT_EQ(state(), method::checks::CheckState::passed);
  for (const double limit_Nm : {4.4, 4.0}) {
    s.noise.effects.torque_limit_Nm = limit_Nm;
    EXPECT_EQ(state(), method::checks::CheckState::fails) << limit_Nm;
  }
}

/// Peaks of a torque that swings in time: among a dozen speeds some are of the same height.
TEST(Saturation, IsNotAnotherJointThatMoves) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    simulate::Scenario s = test::noisy_paper_joint(seed);
    s.rough_sweep.reset();
    s.precise_sweep.reset();
    s.oscillation.reset();
    s.constant_speed->motor_speeds_rad_s.clear();
    for (int k = 0; k < 12; ++k) {
      s.constant_speed->motor_speeds_rad_s.push_back(0.75 * std::pow(400, k / 11.0));
    }
    s.constant_speed->longest_plateau_s = 3;
    s.constant_speed->sample_rate_Hz = 500;
    s.noise.effects.neighbour_Nm = 0.05 * s.load.amplitude_Nm() / s.gear_ratio;
    s.noise.effects.neighbour_Hz = 0.13;
    const joint::Dataset d = simulate::simulated_dataset(s);
    EXPECT_EQ(method::checks::check_torque_saturation(method::checks::look_at(d)).state,
              method::checks::CheckState::passed)
        << seed;
  }
}

/// Without gravity all runs are flat, and friction that hardly grows makes them alike.
TEST(Saturation, IsNotFrictionThatIsTheSameAtAllSpeeds) {
  simulate::Scenario s = test::noisy_paper_joint(2);
  s.load = joint::GravityLoad(1e-6, 1, s.load.q_peak_rad());
  const joint::Dataset d = simulate::simulated_dataset(s);
  EXPECT_EQ(method::checks::check_torque_saturation(method::checks::look_at(d)).state,
            method::checks::CheckState::passed);
}

}  // namespace
}  // namespace tribolog::data_checks_test
