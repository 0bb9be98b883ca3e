#include "method/viscous/direction_lines.h"

#include <cmath>

#include <gtest/gtest.h>

#include "statistics/random_stream.h"
#include "wording/words.h"

namespace tribolog::direction_lines_test {
namespace {

using method::hysteresis::Estimator;

/// Runs of each direction at eight speeds, travelling 1 rad, with friction of their own.
method::viscous::ViscousCurvesResult curves(double rising_Nm, double falling_Nm, double noise_Nm,
                                            std::uint64_t seed) {
  statistics::RandomStream random(seed, 0);
  method::viscous::ViscousCurvesResult v;
  method::viscous::ViscousCurve curve{Estimator::midline, {}};
  for (int k = 1; k <= 8; ++k) {
    for (const double sign : {-1.0, 1.0}) {
      method::viscous::ConstantSpeedRun run;
      run.recording = "run";
      run.speed_rad_s = sign * 10.0 * k;
      run.samples = 100;
      run.lowest_rad = 0;
      run.highest_rad = 1;
      run.partner = static_cast<int>(v.runs.size()) + (sign < 0 ? 1 : -1);
      v.runs.push_back(run);
      const double coulomb = sign > 0 ? rising_Nm : falling_Nm;
      curve.friction_Nm.push_back(sign * (coulomb + 0.02 * 10.0 * k) + noise_Nm * random.normal());
    }
  }
  // With G = 0 the mean of the pair is the asymmetry itself.
  for (std::size_t i = 0; i < v.runs.size(); ++i) {
    const auto partner = static_cast<std::size_t>(v.runs[i].partner);
    v.runs[i].direction_mean_Nm = (curve.friction_Nm[i] + curve.friction_Nm[partner]) / 2;
    v.runs[i].direction_mean_cos = 1;
  }
  v.curves = {curve};
  return v;
}

TEST(DirectionLines, EachDirectionIsFoundByItself) {
  const method::viscous::DirectionLinesResult r =
      method::viscous::fit_direction_lines(curves(12.4, 10.9, 0, 1), Estimator::midline);
  const method::viscous::CurveDirectionLines* lines = r.find(Estimator::midline);
  ASSERT_NE(lines, nullptr);
  ASSERT_TRUE(lines->rising && lines->falling);
  EXPECT_NEAR(lines->rising->coulomb_Nm.value, 12.4, 1e-10);
  EXPECT_NEAR(lines->falling->coulomb_Nm.value, 10.9, 1e-10);
  EXPECT_NEAR(lines->falling->viscous_Nms_rad.value, 0.02, 1e-12);
  EXPECT_EQ(lines->rising->runs, 8U);
}

TEST(DirectionLines, ShortWaysAndTheStribeckDipAreLeftOut) {
  method::viscous::ViscousCurvesResult v = curves(12, 12, 0, 1);
  method::viscous::ConstantSpeedRun brief;  // a tenth of the others' way, on a crest of the ripple
  brief.recording = "brief";
  brief.speed_rad_s = 5;
  brief.samples = 100;
  brief.highest_rad = 0.1;
  v.runs.push_back(brief);
  v.curves[0].friction_Nm.push_back(15);
  const auto first = method::viscous::fit_direction_lines(v, Estimator::midline);
  EXPECT_EQ(first.find(Estimator::midline)->rising->runs_left_out, 1U);
  EXPECT_NEAR(first.find(Estimator::midline)->rising->coulomb_Nm.value, 12, 1e-10);
  v.runs.back().highest_rad = 1;  // as long as the others: now it is the Stribeck effect
  const auto second = method::viscous::fit_direction_lines(v, Estimator::midline);
  EXPECT_EQ(second.find(Estimator::midline)->rising->runs_left_out, 1U);
  EXPECT_NEAR(second.find(Estimator::midline)->rising->coulomb_Nm.value, 12, 1e-10);
  EXPECT_NEAR(second.find(Estimator::midline)->rising->slowest_rad_s, 10, 1e-12);
}

TEST(DirectionLines, PiecesOfARunCountOnce) {
  method::viscous::ViscousCurvesResult v = curves(12, 12, 0, 1);
  for (int piece = 0; piece < 5; ++piece) {  // 40 rad/s again and again, in one recording
    v.runs.push_back(v.runs[7]);
    v.curves[0].friction_Nm.push_back(v.curves[0].friction_Nm[7]);
  }
  EXPECT_EQ(method::viscous::fit_direction_lines(v, Estimator::midline)
                .find(Estimator::midline)
                ->rising->runs,
            8U);
}

TEST(DirectionLines, OneDirectionAloneHasItsLine) {
  method::viscous::ViscousCurvesResult v = curves(12, 12, 0, 1);
  method::viscous::ViscousCurvesResult rising;
  rising.curves = {{Estimator::midline, {}}};
  for (std::size_t i = 1; i < v.runs.size(); i += 2) {
    rising.runs.push_back(v.runs[i]);
    rising.curves[0].friction_Nm.push_back(v.curves[0].friction_Nm[i]);
  }
  const method::viscous::DirectionLinesResult r =
      method::viscous::fit_direction_lines(rising, Estimator::midline);
  EXPECT_TRUE(r.find(Estimator::midline)->rising);
  EXPECT_FALSE(r.find(Estimator::midline)->falling);
  EXPECT_TRUE(method::viscous::fit_direction_lines(rising, std::nullopt).curves.empty());
}

method::hysteresis::SurrogateMass weightless(double half_width_Nm) {
  method::hysteresis::SurrogateMass m;
  m.estimator = Estimator::midline;
  m.gravity_Nm = statistics::symmetric_estimate(0, half_width_Nm);
  return m;
}

TEST(DirectionAsymmetry, IsHalfTheDifferenceOfTheDirections) {
  const method::hysteresis::SurrogateMass m = weightless(0.01);
  const auto a = method::viscous::identify_direction_asymmetry(curves(12.4, 10.9, 0.05, 2), &m, 0);
  ASSERT_TRUE(a.examined);
  EXPECT_TRUE(a.found) << wording::words(a.sentence);
  EXPECT_NEAR(a.mean_Nm.value, 0.75, 0.06);
  EXPECT_EQ(a.speed_rad_s.size(), 8U);
}

// What an error of gravity within its interval explains is no finding.
TEST(DirectionAsymmetry, AnUncertainGravityExplainsIt) {
  const method::hysteresis::SurrogateMass m = weightless(1.0);
  const auto a = method::viscous::identify_direction_asymmetry(curves(12.4, 10.9, 0.05, 2), &m, 0);
  EXPECT_TRUE(a.examined);
  EXPECT_FALSE(a.found) << wording::words(a.sentence);
}

TEST(DirectionAsymmetry, NoneIsFoundWhereThereIsNone) {
  const method::hysteresis::SurrogateMass m = weightless(0.001);
  int found = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    found += method::viscous::identify_direction_asymmetry(curves(12, 12, 0.05, seed), &m, 0).found;
  }
  EXPECT_LE(found, 12);  // 5 % of 100 seeds, with room for their own scatter
  const auto nothing = method::viscous::identify_direction_asymmetry({}, &m, 0);
  EXPECT_FALSE(nothing.examined);
  EXPECT_FALSE(nothing.sentence.empty());
}

}  // namespace
}  // namespace tribolog::direction_lines_test
