// Coulomb torque, Stribeck velocity and viscous coefficient of curves whose law is known: found,
// covered by their intervals, and refused where the speeds do not show them.

#include "method/viscous/sliding_law.h"

#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "statistics/random_stream.h"

namespace tribolog::sliding_law_test {
namespace {

using method::viscous::SlidingLaw;
using method::viscous::SlidingQuantity;

struct Truth {
  double coulomb_Nm{0.6};
  double excess_Nm{0.28};
  double stribeck_rad_s{5};
  double viscous_Nms_rad{0.001};
  double exponent{2};
  double power{1};

  [[nodiscard]] double friction_Nm(double w) const {
    return coulomb_Nm + excess_Nm * std::exp(-std::pow(w / stribeck_rad_s, exponent)) +
           viscous_Nms_rad * std::pow(w, power);
  }
};

constexpr double noise_Nm = 0.002;

std::vector<double> speeds(double slowest, double fastest, int count) {
  std::vector<double> all;
  for (int k = 0; k < count; ++k) {
    all.push_back(slowest * std::pow(fastest / slowest, static_cast<double>(k) / (count - 1)));
  }
  return all;
}

/// Both directions of each speed. @param gravity_Nm error of the gravity torque.
std::vector<method::viscous::CurveSample> curve(const Truth& truth, const std::vector<double>& at,
                                                std::uint64_t seed, double gravity_Nm = 0) {
  statistics::RandomStream random(seed, 0);
  std::vector<method::viscous::CurveSample> samples;
  for (std::size_t k = 0; k < at.size(); ++k) {
    for (const double direction : {-1.0, 1.0}) {
      method::viscous::CurveSample s;
      s.speed_rad_s = at[k];
      s.friction_Nm =
          truth.friction_Nm(at[k]) + direction * gravity_Nm + noise_Nm * random.normal();
      s.direction = direction;
      s.group = k;
      // Ten blocks tell the noise to a quarter.
      s.standard_error_Nm = noise_Nm * std::exp(0.24 * random.normal());
      s.count = 1000;
      s.run = samples.size();
      samples.push_back(s);
    }
  }
  return samples;
}

SlidingLaw law_of(const std::vector<method::viscous::CurveSample>& samples) {
  return method::viscous::fit_sliding_law(samples, {});
}

bool covers(const SlidingQuantity& found, double truth) {
  return found.estimate && found.estimate->low <= truth && truth <= found.estimate->high;
}

const std::vector<double> twelve = speeds(0.75, 300, 12);

TEST(SlidingLaw, FindsAViscousTermThatGrowsNearlyWithTheSquare) {
  Truth truth;
  truth.power = 1.8;
  truth.viscous_Nms_rad = 1e-5;
  int covered = 0;
  constexpr int seeds = 40;
  for (int seed = 1; seed <= seeds; ++seed) {
    const SlidingLaw law = law_of(curve(truth, twelve, static_cast<std::uint64_t>(seed)));
    EXPECT_NEAR(law.viscous_exponent, 1.8, 0.2) << seed;
    covered += covers(law.coulomb_Nm, 0.6) && covers(law.stribeck_speed_rad_s, 5) ? 1 : 0;
  }
  EXPECT_GE(covered, 0.88 * seeds);
}

TEST(SlidingLaw, ACurveThatOnlyBendsHasNoStribeckVelocityToUse) {
  Truth truth;
  truth.excess_Nm = 0;
  truth.power = 1.8;
  truth.viscous_Nms_rad = 1e-5;
  int usable = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const SlidingLaw law = law_of(curve(truth, twelve, seed));
    usable += law.stribeck_speed_rad_s.why_not.empty() ? 1 : 0;
  }
  EXPECT_LE(usable, 1);
}

/// Of a power that a straight line is not excluded by, the interval holds what it does to Coulomb
/// torque.
TEST(SlidingLaw, APowerThatIsNotSureIsInTheInterval) {
  Truth truth;
  truth.power = 1.5;
  truth.viscous_Nms_rad = 2e-4;
  const std::vector<double> slow = speeds(0.75, 30, 12);
  int covered = 0;
  constexpr int seeds = 100;
  for (int seed = 1; seed <= seeds; ++seed) {
    const SlidingLaw law = law_of(curve(truth, slow, static_cast<std::uint64_t>(seed)));
    covered += covers(law.coulomb_Nm, 0.6) ? 1 : 0;
  }
  EXPECT_GE(covered, 88);
}

TEST(SlidingLaw, CoversTheTruthAndIsNarrow) {
  constexpr int seeds = 100;
  const Truth truth;
  int coulomb = 0;
  int stribeck = 0;
  int viscous = 0;
  for (int seed = 1; seed <= seeds; ++seed) {
    const SlidingLaw law = law_of(curve(truth, twelve, seed, 0.01));
    ASSERT_TRUE(law.fitted && law.has_dip);
    coulomb += covers(law.coulomb_Nm, truth.coulomb_Nm);
    stribeck += covers(law.stribeck_speed_rad_s, truth.stribeck_rad_s);
    viscous += covers(law.viscous_Nms_rad, truth.viscous_Nms_rad);
    EXPECT_LT(law.coulomb_Nm.estimate->half_width(), 0.02 * truth.coulomb_Nm);
    EXPECT_LT(law.stribeck_speed_rad_s.estimate->half_width(), 0.1 * truth.stribeck_rad_s);
  }
  for (const int inside : {coulomb, stribeck, viscous}) EXPECT_GE(inside, 90);
}

TEST(SlidingLaw, LateDipIsNoCoulombTorque) {
  Truth truth;
  for (const double late : {10.0, 25.0, 50.0}) {
    truth.stribeck_rad_s = late;
    const SlidingLaw law = law_of(curve(truth, twelve, 3));
    EXPECT_NEAR(law.coulomb_Nm.estimate->value, truth.coulomb_Nm, 0.02 * truth.coulomb_Nm) << late;
    EXPECT_NEAR(law.stribeck_speed_rad_s.estimate->value, late, 0.05 * late);
  }
}

TEST(SlidingLaw, ExponentOtherThanTwo) {
  Truth truth;
  truth.exponent = 1;
  const SlidingLaw law = law_of(curve(truth, speeds(0.75, 300, 16), 5));
  EXPECT_TRUE(covers(law.coulomb_Nm, truth.coulomb_Nm));
  EXPECT_TRUE(covers(law.stribeck_speed_rad_s, truth.stribeck_rad_s));
  EXPECT_LT(law.stribeck_exponent, 1.5);
}

// A gearless motor's losses rise ever less with the speed: the power law that fits best has a
// negative Coulomb torque, which no joint has.
TEST(SlidingLaw, AConcaveCurveHasNoNegativeCoulombTorque) {
  Truth truth;
  truth.coulomb_Nm = 0.02;
  truth.excess_Nm = 0;
  truth.viscous_Nms_rad = 0.011;
  truth.power = 0.5;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const SlidingLaw law = law_of(curve(truth, speeds(15, 126, 8), seed));
    ASSERT_TRUE(law.coulomb_Nm.estimate);
    EXPECT_GE(law.coulomb_Nm.estimate->value, -noise_Nm) << seed;
    EXPECT_TRUE(covers(law.coulomb_Nm, truth.coulomb_Nm)) << seed;
  }
}

TEST(SlidingLaw, LineShowsNoStribeckVelocity) {
  Truth truth;
  truth.excess_Nm = 0;
  const SlidingLaw law = law_of(curve(truth, twelve, 7));
  EXPECT_FALSE(law.has_dip);
  EXPECT_FALSE(law.stribeck_speed_rad_s.estimate);
  EXPECT_EQ(law.stribeck_speed_rad_s.why_not.code(), Code{"cause.stribeck_not_shown"});
  EXPECT_TRUE(covers(law.coulomb_Nm, truth.coulomb_Nm));
  EXPECT_LT(law.coulomb_Nm.estimate->half_width(), 0.1 * truth.coulomb_Nm);
}

TEST(SlidingLaw, StraySpeedIsLeftOutAndNamed) {
  const Truth truth;
  auto samples = curve(truth, twelve, 9);
  for (auto& s : samples) {
    if (s.group == 6) s.friction_Nm += 0.1;
  }
  const SlidingLaw law = law_of(samples);
  ASSERT_EQ(law.left_out.size(), 1U);
  EXPECT_NEAR(law.left_out.front().off_Nm, 0.1, 0.02);
  EXPECT_TRUE(covers(law.coulomb_Nm, truth.coulomb_Nm));
  EXPECT_EQ(law.findings.front().code(), Code{"cause.outliers_of_speeds"});
}

// A drive's limit cuts the slow runs that lift: their mean with the falling ones is a smooth curve
// still, and a wrong one.
TEST(SlidingLaw, DirectionsThatDisagreeAreDoubtful) {
  const Truth truth;
  auto samples = curve(truth, twelve, 11);
  for (auto& s : samples) {
    const double cut = truth.friction_Nm(s.speed_rad_s) - 0.78;
    if (s.direction > 0 && cut > 0) s.friction_Nm -= cut;
  }
  const SlidingLaw law = law_of(samples);
  EXPECT_FALSE(law.coulomb_Nm.why_not.empty());
}

TEST(SlidingLaw, ViscousTermThatIsNotLinearIsSaid) {
  Truth truth;
  truth.excess_Nm = 0.3;
  truth.viscous_Nms_rad = 0.03;
  truth.power = 0.5;
  const SlidingLaw law = law_of(curve(truth, speeds(0.75, 300, 20), 13));
  EXPECT_NEAR(law.viscous_exponent, truth.power, 0.1);
  EXPECT_EQ(law.viscous_Nms_rad.why_not.code(), Code{"curve_model.viscous_not_linear"});
}

TEST(SlidingLaw, TwoSpeedsAreTooFew) { EXPECT_FALSE(law_of(curve(Truth{}, {1, 10}, 1)).fitted); }

}  // namespace
}  // namespace tribolog::sliding_law_test
