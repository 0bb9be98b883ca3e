// The friction curve of points that were read elsewhere: known laws are found, with intervals that
// hold them, and nothing is asked for that no table of friction has.

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "identify/identify.h"
#include "statistics/random_stream.h"
#include "support/breadth.h"

namespace tribolog::identified_friction_points_test {
namespace {

using calibration::Calibration;
using calibration::QuantityVerdict;
using calibration::Verdict;
using joint::Quantity;

struct Law {
  double coulomb_Nm, excess_Nm, stribeck_rad_s, viscous_Nms_rad, offset_Nm;
  [[nodiscard]] double torque_Nm(double speed) const {
    const double size = coulomb_Nm + excess_Nm * std::exp(-std::pow(speed / stribeck_rad_s, 2)) +
                        viscous_Nms_rad * std::abs(speed);
    return std::copysign(size, speed) + offset_Nm;
  }
};

constexpr Law with_dip{0.6, 0.28, 5, 0.002, 0};

joint::Dataset points_of(const Law& law, double noise_Nm, int repeats, std::uint64_t seed) {
  joint::Dataset d;
  d.manifest.robot = "R";
  d.manifest.joint = "J";
  d.manifest.drive = joint::Drive(100, joint::EffortKind::motor_torque, joint::Side::motor);
  d.manifest.known_gravity = joint::StatedGravity(0, 0);
  joint::FrictionPoints p;
  p.name = "points.csv";
  statistics::RandomStream random(seed, 0);
  for (const double size : {0.5, 1.0, 2.0, 3.0, 5.0, 8.0, 12.0, 20.0, 35.0, 60.0, 100.0}) {
    for (const double speed : {size, -size}) {
      for (int k = 0; k < repeats; ++k) {
        p.speed_rad_s.push_back(speed);
        p.torque_Nm.push_back(law.torque_Nm(speed) + noise_Nm * random.normal());
      }
    }
  }
  p.rows_read = p.size();
  d.friction_points.push_back(std::move(p));
  return d;
}

Calibration identified(const joint::Dataset& d, std::size_t truth_runs = 0) {
  identify::IdentifyOptions options;
  options.truth_runs = truth_runs;
  return identify::identify(d, options);
}

const QuantityVerdict& verdict_on(const Calibration& c, Quantity quantity) {
  return *std::find_if(c.judgement.quantities.begin(), c.judgement.quantities.end(),
                       [&](const QuantityVerdict& q) { return q.quantity == quantity; });
}

TEST(IdentifiedFrictionPoints, AreAllThatACurveNeeds) {
  const Calibration c = identified(points_of(with_dip, 0.004, 2, 1), 3);
  EXPECT_EQ(c.judgement.verdict, Verdict::usable);
  EXPECT_NEAR(verdict_on(c, Quantity::coulomb_torque).estimate->value, 0.6, 0.006);
  EXPECT_NEAR(verdict_on(c, Quantity::viscous_coefficient).estimate->value, 0.002, 1e-4);
  EXPECT_NEAR(verdict_on(c, Quantity::stribeck_speed).estimate->value, 5, 0.25);
  for (const Quantity quantity : {Quantity::cog_angle, Quantity::gravity_torque,
                                  Quantity::break_away_torque, Quantity::bristle_stiffness}) {
    const QuantityVerdict& q = verdict_on(c, quantity);
    EXPECT_EQ(q.verdict, Verdict::not_identifiable);
    EXPECT_FALSE(q.decides);
    EXPECT_FALSE(q.estimate);
  }
  EXPECT_TRUE(c.truth_check.findings.empty());
  EXPECT_GE(c.truth_check.quantities.size(), 2U) << "points are simulated, too";
}

TEST(IdentifiedFrictionPoints, AnOffsetOfTheTorqueIsNoFriction) {
  Law law = with_dip;
  law.offset_Nm = 0.05;
  const Calibration c = identified(points_of(law, 0.002, 2, 1));
  EXPECT_NEAR(verdict_on(c, Quantity::coulomb_torque).estimate->value, 0.6, 0.006);
}

TEST(IdentifiedFrictionPoints, IntervalsHoldTheLaw) {
  const auto runs = static_cast<int>(test::seeds_of(30, 100));
  const double least = runs >= 100 ? 0.87 : test::least_coverage(static_cast<std::size_t>(runs));
  const Quantity quantities[] = {Quantity::coulomb_torque, Quantity::stribeck_speed,
                                 Quantity::viscous_coefficient};
  const double truths[] = {0.6, 5, 0.002};
  for (const int repeats : {1, 3}) {
    int inside[3] = {};
    int usable[3] = {};
    for (int run = 0; run < runs; ++run) {
      const Calibration c =
          identified(points_of(with_dip, 0.006, repeats, 10 + static_cast<std::uint64_t>(run)));
      for (int k = 0; k < 3; ++k) {
        const QuantityVerdict& q = verdict_on(c, quantities[k]);
        ASSERT_TRUE(q.estimate);
        inside[k] += q.estimate->low <= truths[k] && truths[k] <= q.estimate->high ? 1 : 0;
        usable[k] += q.verdict == Verdict::usable ? 1 : 0;
      }
    }
    for (int k = 0; k < 3; ++k) {
      EXPECT_GE(inside[k], least * runs) << to_string(quantities[k]) << ", " << repeats;
      // Single points leave the slope known to about what is needed.
      const double least_usable = repeats == 1 && k == 2 ? 0.3 : 0.9;
      EXPECT_GE(usable[k], least_usable * runs) << to_string(quantities[k]) << ", " << repeats;
    }
  }
}

/// One table, one mirrored: the same friction.
TEST(IdentifiedFrictionPoints, MirroredAreTheSame) {
  joint::Dataset d = points_of(with_dip, 0.004, 2, 3);
  const Calibration as_read = identified(d);
  for (double& speed : d.friction_points[0].speed_rad_s) speed = -speed;
  for (double& torque : d.friction_points[0].torque_Nm) torque = -torque;
  const Calibration mirrored = identified(d);
  for (const Quantity quantity : {Quantity::coulomb_torque, Quantity::viscous_coefficient}) {
    const double value = verdict_on(as_read, quantity).estimate->value;
    EXPECT_NEAR(verdict_on(mirrored, quantity).estimate->value, value, 1e-7 * value);
  }
}

}  // namespace
}  // namespace tribolog::identified_friction_points_test
