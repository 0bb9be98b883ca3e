#include "robot/serial_arm.h"

#include <cmath>
#include <cstddef>
#include <utility>

#include "base/statement.h"
#include "joint/degrees.h"
#include "robot/joint_axis.h"

namespace tribolog::robot {
namespace {

constexpr double angle_slack_rad = 1e-9;  // degrees in a file, turned into radians and back

void check_shape(const ArmJoint& joint) {
  const LinkShape& shape = joint.shape;
  for (const double size :
       {shape.radius_m, shape.end_radius_m, shape.drum_radius_m, shape.drum_length_m}) {
    if (!(size > 0) || !std::isfinite(size)) {
      throw Refusal({"arm.size_not_positive", {{"size_m", size}, {"joint", joint.name}}});
    }
  }
  if (!(shape.bar_thickness_m >= 0) || !std::isfinite(shape.bar_thickness_m)) {
    throw Refusal({"arm.thickness_negative",
                   {{"thickness_m", shape.bar_thickness_m}, {"joint", joint.name}}});
  }
}

void check(const ArmJoint& joint) {
  if (joint.name.empty()) throw Refusal({"arm.joint_without_name"});
  check_axis(joint.axis, joint.name);
  if (!joint.offset_m.allFinite())
    throw Refusal({"arm.offset_not_finite", {{"joint", joint.name}}});
  for (const Eigen::Vector3d& bend : joint.link_bends_m) {
    if (!bend.allFinite()) throw Refusal({"arm.bend_not_finite", {{"joint", joint.name}}});
  }
  if (!std::isfinite(joint.lowest_rad) || !std::isfinite(joint.highest_rad) ||
      !(joint.lowest_rad < joint.highest_rad)) {
    throw Refusal({"arm.range_empty",
                   {{"lowest_deg", joint.lowest_rad * joint::degrees_per_rad},
                    {"highest_deg", joint.highest_rad * joint::degrees_per_rad},
                    {"joint", joint.name}}});
  }
  check_shape(joint);
}

}  // namespace

SerialArm::SerialArm(std::string name, std::vector<ArmJoint> joints, Eigen::Vector3d tool_m)
    : name_(std::move(name)), joints_(std::move(joints)), tool_m_(std::move(tool_m)) {
  if (joints_.empty()) throw Refusal({"arm.no_joint"});
  if (!tool_m_.allFinite()) throw Refusal({"arm.flange_not_finite"});
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    check(joints_[i]);
    joints_[i].axis.normalize();
    for (std::size_t k = 0; k < i; ++k) {
      if (joints_[k].name != joints_[i].name) continue;
      throw Refusal({"arm.name_given_twice", {{"joint", joints_[i].name}}});
    }
  }
  if (!(length_m() > 0)) throw Refusal({"arm.without_length"});
}

double SerialArm::length_m() const {
  double sum = tool_m_.norm();
  for (const ArmJoint& joint : joints_) sum += joint.offset_m.norm();
  return sum;
}

std::size_t SerialArm::index_of(const std::string& joint) const {
  std::string names;
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    if (joints_[i].name == joint) return i;
    names += (i > 0 ? ", '" : "'") + joints_[i].name + "'";
  }
  throw Refusal({"arm.no_such_joint", {{"joint", joint}, {"joints", names}}});
}

ArmPose SerialArm::pose(const std::vector<double>& angles_rad) const {
  if (angles_rad.size() != joints_.size()) {
    throw Refusal({"arm.wrong_number_of_angles",
                   {{"angles", angles_rad.size()}, {"joints", joints_.size()}}});
  }
  ArmPose out;
  Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    const ArmJoint& joint = joints_[i];
    const double angle = angles_rad[i];
    if (!(angle >= joint.lowest_rad - angle_slack_rad &&
          angle <= joint.highest_rad + angle_slack_rad)) {
      throw Refusal({"arm.angle_out_of_range",
                     {{"angle_deg", angle * joint::degrees_per_rad},
                      {"lowest_deg", joint.lowest_rad * joint::degrees_per_rad},
                      {"highest_deg", joint.highest_rad * joint::degrees_per_rad},
                      {"joint", joint.name}}});
    }
    frame = frame * Eigen::Translation3d(joint.offset_m) * Eigen::AngleAxisd(angle, joint.axis);
    out.frames.push_back(frame);
  }
  out.tool_m = frame * tool_m_;
  out.tool_frame = frame * Eigen::Translation3d(tool_m_);
  return out;
}

Eigen::Vector3d SerialArm::axis(const ArmPose& pose, std::size_t joint) const {
  return pose.frames[joint].linear() * joints_[joint].axis;
}

}  // namespace tribolog::robot
