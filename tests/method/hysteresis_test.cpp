#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>

#include <gtest/gtest.h>

#include "method/hysteresis/hysteresis_loop.h"
#include "method/hysteresis/surrogate_masses.h"
#include "support/paper_joint.h"
#include "wording/words.h"

namespace tribolog::hysteresis_test {
namespace {

using method::hysteresis::Estimator;

const statistics::Estimate peak = statistics::symmetric_estimate(test::true_q_peak_rad(), 1e-6);

method::hysteresis::Hysteresis hysteresis_of(const joint::Dataset& d) {
  return method::hysteresis::identify_hysteresis(d.with_role(joint::Role::oscillation), {}, {}, 100,
                                                 peak);
}

TEST(Hysteresis, PointsAreThoseOfAnIndependentSolver) {
  // The reconstructed joint solved by an implicit method, in the order A..F.
  constexpr double solved_Nm[] = {3.93168, 3.85868, 4.76230, 2.99954, 3.69472, 4.06883};
  const method::hysteresis::HysteresisResult h =
      hysteresis_of(simulate::simulated_dataset(test::paper_joint())).result;
  ASSERT_EQ(h.points.size(), 6U);
  EXPECT_TRUE(h.bristle_source.is("loop.bristle_recorded"));
  for (std::size_t k = 0; k < 6; ++k) {
    EXPECT_EQ(h.points[k].name, method::hysteresis::loop_points[k]);
    EXPECT_NEAR(h.points[k].torque_Nm, solved_Nm[k], 1e-4) << to_string(h.points[k].name);
  }
  // Order of time: A, C, F, B, D, E.
  const auto t = [&](std::size_t k) { return h.points[k].t_s; };
  EXPECT_LT(t(0), t(2));
  EXPECT_LT(t(2), t(5));
  EXPECT_LT(t(5), t(1));
  EXPECT_LT(t(1), t(3));
  EXPECT_LT(t(3), t(4));
  EXPECT_EQ(t(0), 0);
}

TEST(Hysteresis, PointsMeanWhatTheyAreDefinedAs) {
  const method::hysteresis::Hysteresis h =
      hysteresis_of(simulate::simulated_dataset(test::paper_joint()));
  const auto& p = h.result.points;
  const double z_max = p[2].z_rad;
  EXPECT_NEAR(p[0].z_rad, 0, 1e-12);
  EXPECT_GT(p[0].dz_rad_s, 0);
  EXPECT_NEAR(p[1].z_rad, 0, 1e-4 * z_max);
  EXPECT_LT(p[1].dz_rad_s, 0);
  EXPECT_LT(p[3].z_rad, 0);
  EXPECT_LT(p[4].z_rad, 0);
  EXPECT_GT(p[4].dz_rad_s, 0);
  EXPECT_GT(p[5].z_rad, 0);
  EXPECT_LT(p[5].dz_rad_s, 0);
  for (double z : h.traces.front().z_rad) EXPECT_LE(std::abs(z), std::abs(p[3].z_rad) * (1 + 1e-3));
}

TEST(Hysteresis, MidlineAndPairMeansAreFreeOfFriction) {
  const joint::Dataset d = simulate::simulated_dataset(test::paper_joint());
  const method::hysteresis::HysteresisResult h = hysteresis_of(d).result;
  const auto m = method::hysteresis::identify_surrogate_masses({}, h, peak, 100, 0.5, 9.81);
  for (const Estimator estimator :
       {Estimator::midline, Estimator::AB, Estimator::CD, Estimator::EF}) {
    ASSERT_NE(m.find(estimator), nullptr) << to_string(estimator);
    EXPECT_NEAR(m.find(estimator)->mass_kg.value, test::true_surrogate_mass_kg, 1e-4)
        << to_string(estimator);
  }
  // While single points are not: A and B lie on opposite sides.
  EXPECT_GT(m.find(Estimator::A)->mass_kg.value, test::true_surrogate_mass_kg + 0.5);
  EXPECT_LT(m.find(Estimator::B)->mass_kg.value, test::true_surrogate_mass_kg - 0.3);
}

// Friction then cancels in their mean, however noise shifts the flat top at which they lie.
TEST(Hysteresis, PointsEAndFOfTheSteadyLoopAreHalfAPeriodApart) {
  simulate::Scenario s = test::paper_joint();
  s.noise.torque_white_Nm = 0.02;
  s.noise.encoder_counts_per_turn = 65536;
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    s.noise.seed = seed;
    joint::Dataset d = simulate::simulated_dataset(s);
    for (joint::Recording& r : d.recordings) {  // found by the fit, as of a real joint
      r.z_rad.clear();
      r.dz_rad_s.clear();
    }
    const method::hysteresis::HysteresisResult h = hysteresis_of(d).result;
    ASSERT_EQ(h.steady_points.size(), 6U);
    const method::hysteresis::LoopPoint& e = h.steady_points[4];
    const method::hysteresis::LoopPoint& f = h.steady_points[5];
    const double period_s = 1 / h.oscillations.front().frequency_Hz;
    EXPECT_NEAR(e.t_s - f.t_s, period_s / 2, 1e-9);
    EXPECT_NEAR((e.torque_Nm + f.torque_Nm) / 2, test::true_gravity_Nm,
                std::hypot(e.torque_high_Nm - e.torque_Nm, f.torque_high_Nm - f.torque_Nm));
  }
}

TEST(Hysteresis, MidlineHoldsForAnyAmplitudeAndFrequency) {
  for (const double amplitude : {2e-5, 1e-4, 1e-3}) {
    for (const double frequency : {0.3, 1.0, 7.3}) {
      simulate::Scenario s = test::paper_joint();
      s.oscillation->amplitude_rad = amplitude;
      s.oscillation->frequency_Hz = frequency;
      s.oscillation->cycles = 12;
      const method::hysteresis::HysteresisResult h =
          hysteresis_of(simulate::simulated_dataset(s)).result;
      ASSERT_TRUE(h.midline_Nm) << amplitude << " rad at " << frequency << " Hz";
      EXPECT_NEAR(h.midline_Nm->value / h.midline_mean_cos, test::true_gravity_Nm,
                  1e-4 * test::true_gravity_Nm)
          << amplitude << " rad at " << frequency << " Hz";
    }
  }
}

TEST(Hysteresis, RestAroundTheOscillationDoesNotSpoilIt) {
  joint::Dataset d = simulate::simulated_dataset(test::paper_joint());
  joint::Recording& r = d.recordings[2];
  ASSERT_EQ(r.role, joint::Role::oscillation);
  joint::Recording padded = r;
  const std::size_t rest = 700;
  const auto pad = [&](std::vector<double>& v, double before) {
    v.insert(v.begin(), rest, before);
  };
  pad(padded.q_rad, r.q_rad.front());
  pad(padded.torque_Nm, test::true_gravity_Nm);
  pad(padded.z_rad, 0);
  pad(padded.dz_rad_s, 0);
  padded.dq_rad_s.clear();
  padded.t_s.clear();
  for (std::size_t i = 0; i < padded.q_rad.size(); ++i)
    padded.t_s.push_back(1e-3 * static_cast<double>(i));
  r = padded;
  const method::hysteresis::HysteresisResult h = hysteresis_of(d).result;
  ASSERT_TRUE(h.midline_Nm);
  EXPECT_NEAR(h.midline_Nm->value, test::true_gravity_Nm, 1e-4 * test::true_gravity_Nm);
  EXPECT_GT(h.samples_at_rest, 600U);
}

TEST(Hysteresis, FromOnePositionTheIntervalIsAsWideAsTheRipple) {
  const auto midline_of = [](const simulate::Scenario& s) {
    const joint::Dataset d = simulate::simulated_dataset(s);
    const method::motion::Sweep sweep(d.with_role(joint::Role::rough_sweep));
    const method::gravity::CogSweepResult rough =
        method::gravity::identify_cog_sweep(method::gravity::SweepKind::rough, sweep, 100).result;
    const method::hysteresis::HysteresisResult h =
        method::hysteresis::identify_hysteresis(d.with_role(joint::Role::oscillation), sweep, rough,
                                                100, rough.q_peak_rad)
            .result;
    return method::hysteresis::identify_surrogate_masses(rough, h, rough.q_peak_rad, 100, 0.5, 9.81)
        .find(Estimator::midline)
        ->gravity_Nm;
  };
  simulate::Scenario s = test::noisy_paper_joint(3);
  EXPECT_LT(midline_of(s).half_width(), 0.002);
  for (const double phase : {0.0, 1.0, 2.0, 3.0, 4.0, 5.0}) {
    s.noise.ripple = {{0.02, 1, phase}, {0.02, 6, 2 * phase}};
    const statistics::Estimate midline = midline_of(s);
    // Two sines of 0.02 N·m: standard deviation 0.02, at most 0.04.
    EXPECT_NEAR(midline.half_width(), 1.96 * 0.02, 0.005);
    EXPECT_LE(midline.low, test::true_gravity_Nm) << phase;
    EXPECT_GE(midline.high, test::true_gravity_Nm) << phase;
  }
}

TEST(Hysteresis, ACoarseEncoderIsRefusedWithItsNumbers) {
  simulate::Scenario s = test::noisy_paper_joint(1);
  s.noise.encoder_counts_per_turn = 4096;  // 1.5e-5 rad at the joint: 13 steps in the loop
  const method::hysteresis::HysteresisResult h =
      hysteresis_of(simulate::simulated_dataset(s)).result;
  EXPECT_FALSE(h.found);
  EXPECT_EQ(h.stage.state, statistics::StageState::not_identifiable);
  EXPECT_EQ(wording::words(h.stage.reason),
            "oscillation.csv: the step of the angle is too coarse for the width of the loop");
  const auto number = [&](std::string_view name) {
    const auto& values = h.stage.reason.values();
    const auto found = std::find_if(values.begin(), values.end(),
                                    [&](const StatedValue& one) { return one.name == name; });
    if (found == values.end()) throw std::logic_error("no value " + std::string(name));
    return std::get<double>(found->value);
  };
  EXPECT_NEAR(number("steps"), 13, 1);
  EXPECT_EQ(number("needed"), 50);
}

TEST(Hysteresis, AllLoopsGetTheirBristleFromOneFit) {
  simulate::Scenario s = test::noisy_paper_joint(2);
  simulate::OscillationExperiment further = *s.oscillation;
  further.centre_rad += 0.01;
  s.further_oscillations = {further};
  const method::hysteresis::Hysteresis h = hysteresis_of(simulate::simulated_dataset(s));
  ASSERT_EQ(h.traces.size(), 2U);
  for (const method::hysteresis::LoopTrace& trace : h.traces)
    EXPECT_EQ(trace.z_rad.size(), trace.t_s.size());
  ASSERT_TRUE(h.lugre);
  EXPECT_EQ(h.lugre->fit.loops.size(), 2U);
  const auto m = method::hysteresis::identify_surrogate_masses(
      {}, h.result, peak, 100, 0.5, 9.81, {.loop_fit_Nm = h.lugre->fit.gravity_Nm});
  ASSERT_NE(m.find(Estimator::fit), nullptr);
  EXPECT_NEAR(m.find(Estimator::fit)->mass_kg.value, test::true_surrogate_mass_kg,
              1e-3 * test::true_surrogate_mass_kg);
}

/// Oscillations that drift, and whose angle shakes from sample to sample.
joint::Dataset drifting(double shaking_rad) {
  joint::Dataset d = simulate::simulated_dataset(test::noisy_paper_joint(2));
  for (joint::Recording& r : d.recordings) {
    if (r.role != joint::Role::oscillation) continue;
    for (std::size_t i = 0; i < r.size(); ++i) {
      const auto k = static_cast<double>(i);
      r.q_rad[i] += shaking_rad * std::sin(1e4 * std::sin(k)) - 5e-5 * std::exp(-k / 3000);
    }
  }
  return d;
}

TEST(Hysteresis, ALoopThatIsNoPeriodicMotionIsFittedAlongASpline) {
  const method::hysteresis::Hysteresis h = hysteresis_of(drifting(0));
  ASSERT_TRUE(h.lugre);
  ASSERT_TRUE(h.lugre->fit.converged) << wording::words(h.lugre->fit.reason);
  EXPECT_EQ(h.lugre->fit.loops.front().motion, method::hysteresis::LoopMotion::spline);
}

TEST(Hysteresis, ALoopWhoseAngleIsTooRoughIsNotFitted) {
  const method::hysteresis::Hysteresis h = hysteresis_of(drifting(1e-5));
  ASSERT_TRUE(h.lugre);
  EXPECT_FALSE(h.lugre->fit.converged);
  EXPECT_NE(wording::words(h.lugre->fit.reason).find("not periodic"), std::string::npos)
      << wording::words(h.lugre->fit.reason);
  EXPECT_NE(wording::words(h.lugre->fit.reason).find("too noisy to give a speed"),
            std::string::npos);
  EXPECT_TRUE(h.result.bristle_source.empty());
}

TEST(Hysteresis, NothingRecordedIsSkippedWithAnInstruction) {
  const method::hysteresis::HysteresisResult h =
      method::hysteresis::identify_hysteresis({}, {}, {}, 100, peak).result;
  EXPECT_EQ(h.stage.state, statistics::StageState::skipped);
  EXPECT_NE(wording::words(h.stage.reason).find("a sine of about ten cycles"), std::string::npos);
}

}  // namespace
}  // namespace tribolog::hysteresis_test
