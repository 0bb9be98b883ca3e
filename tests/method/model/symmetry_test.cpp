// What must not change the answer, or must change it in a known way.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "joint/quantity.h"
#include "method/model/joint_log.h"

namespace tribolog::model_symmetry_test {
namespace {

using joint::Quantity;
using joint::Recording;
using method::model::ModelQuantity;
using method::model::ModelResult;
using std::numbers::pi;
using test::found;
using test::friction_at;
using test::half_width;
using test::JointLog;
using test::KnownJoint;

KnownJoint joint_with_dip() {
  KnownJoint joint;
  joint.dip_Nm = 0.1;
  joint.effects = test::SmallEffects::draw(5, 0.25);
  return joint;
}

const JointLog& log_of_joint() {
  static const JointLog log = record(joint_with_dip(), {}, 3);
  return log;
}

const ModelResult& result_of_joint() {
  static const ModelResult result = log_of_joint().identified(50);
  return result;
}

/// Value and interval, of one side a multiple of the other's.
void expect_multiple(const ModelQuantity& q, const ModelQuantity& of, double factor,
                     double tolerance) {
  const double size = tolerance * std::abs(factor * of.estimate);
  EXPECT_NEAR(q.estimate, factor * of.estimate, size);
  EXPECT_NEAR(q.low, factor * of.low, size);
  EXPECT_NEAR(q.high, factor * of.high, size);
}

void expect_within_interval(const ModelQuantity& q, const ModelQuantity& of, double factor,
                            double share) {
  const double half = factor * half_width(of);
  EXPECT_NEAR(q.estimate, factor * of.estimate, share * half);
  EXPECT_NEAR(half_width(q), half, share * half);
}

TEST(ModelSymmetry, MirroredJointHasMirroredAngleAndTheSameFriction) {
  JointLog log = log_of_joint();
  for (Recording& r : log.recordings) {
    for (double& q : r.q_rad) q = -q;
    for (double& torque : r.torque_Nm) torque = -torque;
  }
  const ModelResult mirrored = log.identified(50);
  const ModelResult& straight = result_of_joint();
  ASSERT_EQ(mirrored.cells, straight.cells);
  ASSERT_EQ(mirrored.quantities.size(), straight.quantities.size());
  for (std::size_t k = 0; k < straight.quantities.size(); ++k) {
    const ModelQuantity& one = straight.quantities[k];
    if (one.quantity == Quantity::cog_angle) {
      const ModelQuantity& angle = mirrored.quantities[k];
      EXPECT_NEAR(std::remainder(angle.estimate + one.estimate - pi, 2 * pi), 0, 1e-6);
      EXPECT_NEAR(std::remainder(angle.low + one.high - pi, 2 * pi), 0, 1e-6);
      EXPECT_NEAR(std::remainder(angle.high + one.low - pi, 2 * pi), 0, 1e-6);
    } else {
      expect_multiple(mirrored.quantities[k], one, 1, 1e-6);
    }
  }
}

TEST(ModelSymmetry, AngleHasNoOrigin) {
  JointLog log = log_of_joint();
  constexpr double shift = 2.5;
  for (Recording& r : log.recordings) {
    for (double& q : r.q_rad) q += shift;
  }
  const ModelResult shifted = log.identified(50);
  const ModelResult& straight = result_of_joint();
  for (const ModelQuantity& q : straight.quantities) {
    if (!q.quantity) continue;
    ModelQuantity moved = found(shifted, *q.quantity);
    if (q.quantity == Quantity::cog_angle) {
      const double back = moved.estimate - std::remainder(moved.estimate - shift, 2 * pi);
      moved.estimate -= back;
      moved.low -= back;
      moved.high -= back;
    }
    expect_within_interval(moved, q, 1, 0.2);  // other cells
  }
}

TEST(ModelSymmetry, TorqueHasNoUnit) {
  for (const double factor : {1e-3, 37.0, 1e4}) {
    JointLog log = log_of_joint();
    for (Recording& r : log.recordings) {
      for (double& torque : r.torque_Nm) torque *= factor;
    }
    const ModelResult scaled = log.identified(50);
    const ModelResult& straight = result_of_joint();
    ASSERT_EQ(scaled.quantities.size(), straight.quantities.size());
    for (std::size_t k = 0; k < straight.quantities.size(); ++k) {
      const ModelQuantity& one = straight.quantities[k];
      expect_multiple(scaled.quantities[k], one, one.quantity == Quantity::cog_angle ? 1 : factor,
                      1e-6);
    }
  }
}

TEST(ModelSymmetry, GearRatioCarriesSpeedAndInertia) {
  const ModelResult& straight = result_of_joint();
  const ModelResult twice = log_of_joint().identified(100);
  expect_within_interval(found(twice, Quantity::gravity_torque),
                         found(straight, Quantity::gravity_torque), 1, 0.2);
  expect_within_interval(found(twice, Quantity::cog_angle), found(straight, Quantity::cog_angle), 1,
                         0.2);
  expect_within_interval(found(twice, Quantity::coulomb_torque),
                         found(straight, Quantity::coulomb_torque), 1, 0.2);
  expect_within_interval(found(twice, Quantity::viscous_coefficient),
                         found(straight, Quantity::viscous_coefficient), 0.5, 0.2);
  expect_within_interval(found(twice, Quantity::inertia), found(straight, Quantity::inertia), 0.5,
                         0.2);
  expect_within_interval(friction_at(twice, 40), friction_at(straight, 20), 1, 0.2);
}

TEST(ModelSymmetry, OrderOfRecordingsMovesNumbersWithinTheirIntervals) {
  JointLog log = log_of_joint();
  std::reverse(log.recordings.begin(), log.recordings.end());
  const ModelResult reversed = log.identified(50);
  for (const ModelQuantity& q : result_of_joint().quantities) {
    if (!q.quantity) continue;
    expect_within_interval(found(reversed, *q.quantity), q, 1, 0.5);
  }
}

TEST(ModelSymmetry, OneLogInPartsOrAsAWholeIsTheSame) {
  // Each recording cut into halves that go on from one another, under the same name.
  JointLog parts;
  for (const Recording& r : log_of_joint().recordings) {
    const auto half = static_cast<std::ptrdiff_t>(r.size() / 2);
    for (const bool first : {true, false}) {
      Recording part = r;
      for (auto* values : {&part.t_s, &part.q_rad, &part.torque_Nm}) {
        if (first) {
          values->erase(values->begin() + half, values->end());
        } else {
          values->erase(values->begin(), values->begin() + half);
        }
      }
      parts.recordings.push_back(std::move(part));
    }
  }
  const ModelResult cut = parts.identified(50);
  for (const ModelQuantity& q : result_of_joint().quantities) {
    if (!q.quantity) continue;
    expect_within_interval(found(cut, *q.quantity), q, 1, 0.5);
  }
}

}  // namespace
}  // namespace tribolog::model_symmetry_test
