// What a model leaves of a loop: its own error, told from noise.

#include "method/hysteresis/loop_misfit.h"

#include <cmath>

#include <gtest/gtest.h>

#include "statistics/random_stream.h"

namespace tribolog::loop_misfit_test {
namespace {

/// Ten cycles of a sine; the torque is the noise and an error that turns with the direction.
method::hysteresis::LoopMisfit misfit_of(double error_Nm, double noise_Nm, std::uint64_t seed) {
  statistics::RandomStream random(seed, 0);
  joint::Recording r;
  std::vector<double> speed;
  for (int i = 0; i < 10000; ++i) {
    const double phase = 2 * 3.141592653589793 * i / 1000.0;
    speed.push_back(std::cos(phase));
    r.t_s.push_back(1e-3 * i);
    r.q_rad.push_back(std::sin(phase));
    r.torque_Nm.push_back((speed.back() > 0 ? error_Nm : -error_Nm) + noise_Nm * random.normal());
  }
  return method::hysteresis::loop_misfit(r, std::vector<double>(r.size(), 0.0), speed);
}

TEST(LoopMisfit, FindsTheErrorOfTheModelUnderNoise) {
  EXPECT_NEAR(misfit_of(0.1, 0, 1).systematic_Nm, 0.1, 1e-12);
  EXPECT_NEAR(misfit_of(-0.1, 0.2, 2).systematic_Nm, 0.1, 0.01);
}

// Means of bins scatter by a tenth of the noise here; less than half of that may stay.
TEST(LoopMisfit, OfNoiseAloneHardlyAnythingStays) {
  double squares = 0;
  constexpr int seeds = 50;
  for (int seed = 1; seed <= seeds; ++seed) {
    squares += std::pow(misfit_of(0, 1, static_cast<std::uint64_t>(seed)).systematic_Nm, 2);
  }
  EXPECT_LT(std::sqrt(squares / seeds), 0.05);
}

/// Twenty strokes of growing amplitude, as of a joint driven by a torque; noise that neighbouring
/// samples share.
double repeated(double error_Nm, double noise_Nm, std::uint64_t seed, std::size_t first = 0) {
  statistics::RandomStream random(seed, 0);
  joint::Recording r;
  std::vector<double> turns;
  double noise = 0;
  for (int i = 0; i < 10000; ++i) {
    const double strokes = i / 500.0;
    if (i % 500 == 0 && i > 0) turns.push_back(1e-3 * i);
    if (i % 10 == 0) noise = random.normal();
    const double share = strokes - std::floor(strokes);
    r.t_s.push_back(7 + 1e-3 * i);
    r.q_rad.push_back((1 + strokes) * std::cos(M_PI * strokes));
    r.torque_Nm.push_back((share < 0.2 ? error_Nm : 0) + noise_Nm * noise);
  }
  return method::hysteresis::repeated_misfit_Nm(r, std::vector<double>(r.size(), 0.0), turns,
                                                first);
}

TEST(RepeatedMisfit, FindsWhatTheStrokesShare) {
  EXPECT_NEAR(repeated(0.1, 0, 1), 0.1 * std::sqrt(0.2), 1e-3);
  EXPECT_NEAR(repeated(0.1, 0.05, 2), 0.1 * std::sqrt(0.2), 0.005);
  EXPECT_NEAR(repeated(0.1, 0, 1, 5000), 0.1 * std::sqrt(0.2), 1e-3);
}

TEST(RepeatedMisfit, OfSharedNoiseHardlyAnythingStays) {
  double squares = 0;
  constexpr int seeds = 50;
  for (int seed = 1; seed <= seeds; ++seed) {
    squares += std::pow(repeated(0, 1, static_cast<std::uint64_t>(seed)), 2);
  }
  EXPECT_LT(std::sqrt(squares / seeds), 0.15);  // of means that scatter by a third
}

TEST(RepeatedMisfit, OfTooFewStrokesNothingIsKnown) { EXPECT_EQ(repeated(0.1, 0, 1, 8500), 0); }

}  // namespace
}  // namespace tribolog::loop_misfit_test
