// A recording that is of another joint, sign or payload than the others has no part in the numbers,
// and that is told.

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "joint/quantity.h"
#include "method/model/joint_log.h"

namespace tribolog::foreign_recordings_test {
namespace {

using joint::Quantity;
using joint::Recording;
using method::model::ModelQuantity;
using method::model::ModelResult;
using test::found;
using test::friction_at;
using test::half_width;
using test::holds;
using test::JointLog;
using test::KnownJoint;

constexpr int of_sweep = 1;
constexpr int of_run = 5;

/// Eight recordings: four sweeps and four runs.
test::Session eight() {
  test::Session session;
  session.sweeps = 4;
  session.run_speeds_rad_s = {0.05, 0.2, 0.5, 0.9};
  return session;
}

/// Numbers hold the truth and are those without the recording.
void expect_without(const JointLog& log, int foreign, const KnownJoint& joint) {
  const ModelResult result = log.identified(joint.gear_ratio);
  ASSERT_EQ(result.left_out, std::vector<int>{foreign});
  EXPECT_EQ(result.unlike_left, 0U);
  JointLog others = log;
  others.recordings.erase(others.recordings.begin() + foreign);
  const ModelResult expected = others.identified(joint.gear_ratio);
  EXPECT_TRUE(expected.left_out.empty());
  EXPECT_TRUE(holds(found(result, Quantity::gravity_torque), joint.gravity_Nm));
  EXPECT_TRUE(holds(found(result, Quantity::cog_angle), joint.q_peak_rad));
  EXPECT_TRUE(holds(found(result, Quantity::coulomb_torque), joint.coulomb_Nm));
  EXPECT_TRUE(holds(found(result, Quantity::viscous_coefficient), joint.viscous_Nms_rad));
  EXPECT_TRUE(holds(found(result, Quantity::inertia), joint.inertia_kgm2));
  for (const ModelQuantity& q : expected.quantities) {
    const ModelQuantity& same =
        q.quantity ? found(result, *q.quantity) : friction_at(result, q.speed_rad_s);
    EXPECT_NEAR(same.estimate, q.estimate, 0.25 * half_width(q));
    EXPECT_NEAR(half_width(same), half_width(q), 0.25 * half_width(q));
  }
}

TEST(ForeignRecordings, SoundOnesAreAllKept) {
  KnownJoint joint;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    joint.effects = test::SmallEffects::draw(seed, 0.25);
    const ModelResult result = record(joint, eight(), seed).identified(joint.gear_ratio);
    EXPECT_TRUE(result.left_out.empty()) << "seed " << seed;
    EXPECT_EQ(result.unlike_left, 0U) << "seed " << seed;
  }
}

TEST(ForeignRecordings, TorqueOfTheOtherSignIsLeftOut) {
  const KnownJoint joint;
  for (const int foreign : {of_sweep, of_run}) {
    JointLog log = record(joint, eight(), 1);
    for (double& torque : log.recordings[static_cast<std::size_t>(foreign)].torque_Nm) {
      torque = -torque;
    }
    expect_without(log, foreign, joint);
  }
}

TEST(ForeignRecordings, AnotherPayloadIsLeftOut) {
  const KnownJoint joint;
  KnownJoint loaded = joint;
  loaded.gravity_Nm = 1.3;
  loaded.q_peak_rad = 0.6;
  const JointLog other = record(loaded, eight(), 2);
  for (const int foreign : {of_sweep, of_run}) {
    JointLog log = record(joint, eight(), 1);
    log.recordings[static_cast<std::size_t>(foreign)] =
        other.recordings[static_cast<std::size_t>(foreign)];
    expect_without(log, foreign, joint);
  }
}

TEST(ForeignRecordings, AMajorityOfForeignOnesIsNoneToTrust) {
  // Half of them of the other sign: nobody can tell which half is right.
  JointLog log = test::record({}, eight(), 1);
  for (std::size_t k = 0; k < log.recordings.size(); k += 2) {
    for (double& torque : log.recordings[k].torque_Nm) torque = -torque;
  }
  const ModelResult result = log.identified(50);
  EXPECT_LE(result.left_out.size(), log.recordings.size() / 3);
  const ModelQuantity& gravity = found(result, Quantity::gravity_torque);
  EXPECT_GT(half_width(gravity), 0.2 * std::abs(gravity.estimate));
}

}  // namespace
}  // namespace tribolog::foreign_recordings_test
