// Friction that grows with the load: found again where it is, refused where it is not.

#include "method/viscous/load_dependence.h"

#include <cmath>
#include <numbers>
#include <utility>

#include <gtest/gtest.h>

#include "method/gravity/cog_sweep.h"
#include "statistics/random_stream.h"
#include "wording/words.h"

namespace tribolog::load_dependence_test {
namespace {

constexpr double gravity_Nm = 100.0;
constexpr double coulomb_Nm = 11.0;
constexpr double viscous_Nms_rad = 18.0;
constexpr double q_peak_rad = 0.0;

/// Sines of 1 rad about an angle without load, as the UR10e's; `per_load` of the gravity torque is
/// friction.
joint::Recording sine(double per_load, double noise_Nm, std::uint64_t seed, double centre_rad) {
  statistics::RandomStream random(seed, 0);
  joint::Recording r;
  r.role = joint::Role::rough_sweep;
  constexpr double w = 2 * std::numbers::pi * 0.1;
  for (int i = 0; i < 5000; ++i) {
    const double t = 0.01 * i;
    const double q = centre_rad + std::sin(w * t);
    const double v = w * std::cos(w * t);
    const double gravity = gravity_Nm * std::cos(q - q_peak_rad);
    const double sign = v > 0 ? 1.0 : -1.0;
    r.t_s.push_back(t);
    r.q_rad.push_back(q);
    r.torque_Nm.push_back(gravity + 0.7 + sign * (coulomb_Nm + per_load * std::abs(gravity)) +
                          viscous_Nms_rad * v - 15 * w * w * std::sin(w * t) +
                          noise_Nm * random.normal());
  }
  return r;
}

struct Result {
  method::gravity::CogSweepResult sweep;
  method::viscous::LoadDependenceResult load;
};

Result identify(const joint::Recording& r) {
  Result out;
  const method::motion::Sweep sweep({&r});
  out.sweep =
      method::gravity::identify_cog_sweep(method::gravity::SweepKind::rough, sweep, 1.0).result;
  out.load = method::viscous::identify_load_dependence(sweep, out.sweep, out.sweep.q_peak_rad, 1.0);
  return out;
}

constexpr double no_load_rad = std::numbers::pi / 2;

TEST(LoadDependence, IsFoundAgain) {
  const joint::Recording r = sine(0.06, 1.5, 1, no_load_rad);
  const Result found = identify(r);
  ASSERT_TRUE(found.load.found) << wording::words(found.load.sentence);
  EXPECT_NEAR(found.load.per_load.value, 0.06, 0.006);
  EXPECT_NEAR(found.load.unloaded_Nm.value, coulomb_Nm, 0.5);
  ASSERT_TRUE(found.load.viscous_Nms_rad);
  EXPECT_NEAR(found.load.viscous_Nms_rad->value, viscous_Nms_rad, 1.0);
  EXPECT_LT(found.load.held_out_Nm, 0.5 * found.load.held_out_without_load_Nm);
  // The sweep takes the same term up, and its Coulomb torque is that of the mean load.
  ASSERT_TRUE(found.sweep.load_coulomb_Nm);
  EXPECT_NEAR(found.sweep.load_coulomb_Nm->value, 6.0, 0.5);
  EXPECT_NEAR(found.sweep.unloaded_coulomb_Nm->value, coulomb_Nm, 0.5);
  EXPECT_GT(found.sweep.coulomb_Nm->value, coulomb_Nm + 2);
  // In a sine inertia and gravity look nearly alike.
  EXPECT_NEAR(found.sweep.gravity_Nm.value, gravity_Nm, 0.02 * gravity_Nm);
}

// Without the term the regression lays the load's share on inertia, speed and gravity.
TEST(LoadDependence, CoversAndIsRefusedWhereItIsNot) {
  constexpr int seeds = 100;
  int covered = 0;
  int falsely_found = 0;
  int falsely_taken_up = 0;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    const joint::Recording loaded = sine(0.06, 1.5, seed, no_load_rad);
    const Result with = identify(loaded);
    covered += with.load.per_load.low <= 0.06 && 0.06 <= with.load.per_load.high;
    const joint::Recording plain = sine(0, 1.5, 1000 + seed, no_load_rad);
    const Result without = identify(plain);
    falsely_found += without.load.found;
    falsely_taken_up += without.sweep.load_coulomb_Nm.has_value();
  }
  RecordProperty("covered", covered);
  RecordProperty("falsely_found", falsely_found);
  RecordProperty("falsely_taken_up", falsely_taken_up);
  EXPECT_GE(covered, 88);
  EXPECT_LE(falsely_found, 10);
  EXPECT_LE(falsely_taken_up, 10);
}

/// Rising and falling at a constant speed, from -1.2 to 1.2 rad about the peak; what is logged of
/// the torque is up to the test.
template <class Logged>
Result identify_strokes(double per_load, double friction_Nm, std::uint64_t seed,
                        const Logged& logged, double by_angle = 0) {
  statistics::RandomStream random(seed, 0);
  joint::Recording r;
  r.role = joint::Role::rough_sweep;
  constexpr double speed = 0.08;
  constexpr double half_s = 1.2 / speed;
  for (double t = 0; t < 8 * half_s; t += 0.01) {
    const double within = std::fmod(t, 4 * half_s);
    const bool rises = within < 2 * half_s;
    const double q = rises ? -1.2 + speed * within : 1.2 - speed * (within - 2 * half_s);
    const double gravity = gravity_Nm * std::cos(q - 0.1);
    const double friction =
        friction_Nm * (1 + by_angle * std::cos(2 * q)) + per_load * std::abs(gravity);
    r.t_s.push_back(t);
    r.q_rad.push_back(q);
    r.torque_Nm.push_back(logged(gravity + (rises ? friction : -friction)) + 0.1 * random.normal());
  }
  return identify(r);
}

TEST(LoadDependence, ATorqueThatSaturatesIsToldFromFrictionByLoad) {
  using method::viscous::OutOfProportion;
  constexpr double at_gravity = 0.01;
  const auto saturated = [](double torque) {
    return torque * (1 + at_gravity * std::pow(torque / gravity_Nm, 2));
  };
  const auto as_it_is = [](double torque) { return torque; };
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const auto bent = identify_strokes(0, coulomb_Nm, seed, saturated).load.out_of_proportion;
    ASSERT_TRUE(bent) << seed;
    EXPECT_EQ(bent->form, OutOfProportion::saturation);
    EXPECT_NEAR(bent->share.value, at_gravity * (1 + 3 * std::pow(coulomb_Nm / gravity_Nm, 2)),
                0.002);
    const Result loaded = identify_strokes(0.01, coulomb_Nm, seed, as_it_is);
    EXPECT_TRUE(loaded.load.found) << seed;
    EXPECT_FALSE(loaded.load.out_of_proportion) << seed;
    const Result plain = identify_strokes(0, coulomb_Nm, seed, as_it_is);
    EXPECT_FALSE(plain.load.out_of_proportion) << seed;
  }
}

TEST(LoadDependence, ATorqueThatGrowsByItsMagnitudeIsToldFromFrictionByLoad) {
  using method::viscous::OutOfProportion;
  constexpr double at_gravity = 0.02;
  const auto grown = [](double torque) {
    return torque * (1 + at_gravity * std::abs(torque) / gravity_Nm);
  };
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const auto bent = identify_strokes(0, coulomb_Nm, seed, grown).load.out_of_proportion;
    ASSERT_TRUE(bent) << seed;
    EXPECT_EQ(bent->form, OutOfProportion::saturation);
    EXPECT_NEAR(bent->share.value, at_gravity, 0.006) << seed;
  }
}

TEST(LoadDependence, FrictionThatChangesWithTheAngleIsNoTorqueOutOfProportion) {
  using method::viscous::OutOfProportion;
  constexpr double at_gravity = 0.03;
  const auto saturated = [](double torque) {
    return torque * (1 + at_gravity * std::pow(torque / gravity_Nm, 2));
  };
  const auto as_it_is = [](double torque) { return torque; };
  for (const double by_angle : {-0.05, 0.02, 0.05, 0.2}) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      const Result plain = identify_strokes(0, coulomb_Nm, seed, as_it_is, by_angle);
      EXPECT_FALSE(plain.load.out_of_proportion) << by_angle << ' ' << seed;
      const Result both = identify_strokes(0, coulomb_Nm, seed, saturated, by_angle);
      ASSERT_TRUE(both.load.out_of_proportion) << by_angle << ' ' << seed;
      EXPECT_EQ(both.load.out_of_proportion->form, OutOfProportion::saturation);
      EXPECT_GT(both.load.out_of_proportion->share.value, at_gravity / 2) << by_angle;
    }
  }
}

TEST(LoadDependence, ADeadZoneShowsWhereTheTorqueChangesItsSign) {
  using method::viscous::OutOfProportion;
  constexpr double zone_Nm = 1;
  const auto beyond_zone = [](double torque) { return torque + (torque < 0 ? -zone_Nm : zone_Nm); };
  constexpr double more_friction_Nm = 60;  // than gravity at the ends of the strokes
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const auto dead = identify_strokes(0, more_friction_Nm, seed, beyond_zone).load;
    ASSERT_TRUE(dead.out_of_proportion) << seed;
    EXPECT_EQ(dead.out_of_proportion->form, OutOfProportion::dead_zone);
    EXPECT_NEAR(dead.out_of_proportion->share.value, zone_Nm / gravity_Nm, 0.002);
    // Where it does not, it is an offset of the torque.
    EXPECT_FALSE(identify_strokes(0, coulomb_Nm, seed, beyond_zone).load.out_of_proportion) << seed;
  }
}

/// A slow sine about the gravity peak, of this amplitude.
joint::Recording about_the_peak(double amplitude_rad, double offset_Nm, double saturation) {
  statistics::RandomStream random(4, 0);
  joint::Recording r;
  r.role = joint::Role::rough_sweep;
  constexpr double w = 2 * std::numbers::pi * 0.05;
  for (int i = 0; i < 6000; ++i) {
    const double t = 0.01 * i;
    const double q = amplitude_rad * std::sin(w * t);
    const double v = amplitude_rad * w * std::cos(w * t);
    const double torque =
        gravity_Nm * std::cos(q) + (v > 0 ? 1 : -1) * coulomb_Nm + viscous_Nms_rad * v;
    r.t_s.push_back(t);
    r.q_rad.push_back(q);
    r.torque_Nm.push_back(torque * (1 - saturation * std::pow(torque / gravity_Nm, 2)) + offset_Nm +
                          0.5 * random.normal());
  }
  return r;
}

TEST(LoadDependence, NearThePeakAnOffsetAndASaturationLookAlike) {
  using method::viscous::OutOfProportion;
  for (const auto& [offset, saturation] : {std::pair{0.0, 0.02}, std::pair{3.0, 0.0}}) {
    const Result narrow = identify(about_the_peak(0.7, offset, saturation));
    ASSERT_TRUE(narrow.load.out_of_proportion) << saturation;
    EXPECT_EQ(narrow.load.out_of_proportion->form, OutOfProportion::saturation_or_offset);
    EXPECT_NEAR(narrow.load.out_of_proportion->share.value, saturation > 0 ? -0.02 : -0.025, 0.01);
  }
  EXPECT_FALSE(identify(about_the_peak(0.7, 0, 0)).load.out_of_proportion);
  EXPECT_FALSE(identify(about_the_peak(1.9, 3, 0)).load.out_of_proportion)
      << "further away they do not";
}

TEST(LoadDependence, LittleChangeOfLoadIsSaid) {
  joint::Recording r = sine(0.06, 0.1, 1, q_peak_rad);
  for (std::size_t i = 0; i < r.size(); ++i) {  // a tenth of the stroke, all near the peak
    const double q = r.q_rad[i];
    r.torque_Nm[i] += gravity_Nm * (std::cos(q / 10) - std::cos(q));
    r.q_rad[i] = q / 10;
  }
  const Result at_peak = identify(r);
  EXPECT_FALSE(at_peak.load.examined);
  EXPECT_FALSE(at_peak.load.sentence.empty());
}

TEST(SweepSamples, AnAbruptStopDoesNotBendGravity) {
  joint::Recording r = sine(0, 0.5, 3, no_load_rad);
  // Stops within 0.05 s in full motion, with the torque that this takes.
  const double q_end = r.q_rad.back();
  const double t_end = r.t_s.back();
  for (int i = 1; i <= 30; ++i) {
    r.t_s.push_back(t_end + 0.01 * i);
    r.q_rad.push_back(q_end + (i < 5 ? 0.003 * i : 0.015));
    r.torque_Nm.push_back(i < 8 ? -300.0 : gravity_Nm * std::cos(q_end));
  }
  const method::gravity::CogSweepResult sweep =
      method::gravity::identify_cog_sweep(method::gravity::SweepKind::rough,
                                          method::motion::Sweep({&r}), 1.0)
          .result;
  EXPECT_NEAR(sweep.gravity_Nm.value, gravity_Nm, 1.0);
  EXPECT_NEAR(sweep.q_peak_rad.value, q_peak_rad, 0.01);
}

}  // namespace
}  // namespace tribolog::load_dependence_test
