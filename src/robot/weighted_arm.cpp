#include "robot/weighted_arm.h"

#include <cmath>
#include <numbers>
#include <utility>

#include "base/statement.h"
#include "robot/joint_axis.h"

namespace tribolog::robot {
namespace {

void check_weighted(const std::vector<WeightedJoint>& joints, std::size_t index) {
  const WeightedJoint& joint = joints[index];
  const bool is_behind_parent = !joint.parent || *joint.parent < index;
  const bool follows_a_joint =
      !joint.follows || (joint.follows->joint < joints.size() && joint.follows->joint != index);
  if (!is_behind_parent || !follows_a_joint) {
    throw Refusal({"arm.parent_not_before", {{"joint", joint.name}}});
  }
  check_axis(joint.axis, joint.name);
  if (!joint.at_zero.matrix().allFinite() || !joint.centre_m.allFinite()) {
    throw Refusal({"arm.offset_not_finite", {{"joint", joint.name}}});
  }
  if (!(joint.mass_kg >= 0) || !std::isfinite(joint.mass_kg)) {
    throw Refusal({"arm.mass_negative", {{"mass_kg", joint.mass_kg}, {"joint", joint.name}}});
  }
}

}  // namespace

WeightedArm::WeightedArm(std::vector<WeightedJoint> joints) : joints_(std::move(joints)) {
  if (joints_.empty()) throw Refusal({"arm.no_joint"});
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    check_weighted(joints_, i);
    joints_[i].axis.normalize();
  }
}

double WeightedArm::holding_torque_Nm(std::size_t joint, const std::vector<double>& positions,
                                      const Eigen::Vector3d& gravity_m_s2) const {
  std::vector<Eigen::Isometry3d> frames(joints_.size());
  std::vector<bool> is_carried(joints_.size(), false);
  double torque_Nm = 0;
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    const WeightedJoint& one = joints_[i];
    const double position =
        one.follows ? one.follows->factor * positions[one.follows->joint] + one.follows->offset
                    : positions[i];
    frames[i] = one.parent ? frames[*one.parent] * one.at_zero : one.at_zero;
    if (one.motion == JointMotion::turning) {
      frames[i].rotate(Eigen::AngleAxisd(position, one.axis));
    } else {
      frames[i].translate(Eigen::Vector3d(position * one.axis));
    }
    is_carried[i] = i == joint || (one.parent && is_carried[*one.parent]);
    if (!is_carried[i] || one.mass_kg == 0) continue;
    const Eigen::Vector3d axis = frames[joint].linear() * joints_[joint].axis;
    const Eigen::Vector3d weight_N = one.mass_kg * gravity_m_s2;
    const Eigen::Vector3d lever_m = frames[i] * one.centre_m - frames[joint].translation();
    torque_Nm -= joints_[joint].motion == JointMotion::turning ? axis.dot(lever_m.cross(weight_N))
                                                               : axis.dot(weight_N);
  }
  return torque_Nm;
}

joint::StatedGravity WeightedArm::gravity_of(std::size_t joint, std::vector<double> positions,
                                             const Eigen::Vector3d& gravity_m_s2) const {
  positions[joint] = 0;
  const double at_zero = holding_torque_Nm(joint, positions, gravity_m_s2);
  positions[joint] = std::numbers::pi / 2;
  const double at_quarter = holding_torque_Nm(joint, positions, gravity_m_s2);
  return {std::hypot(at_zero, at_quarter), std::atan2(at_quarter, at_zero)};
}

}  // namespace tribolog::robot
