#include "robot/serial_arm.h"

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "joint/degrees.h"

namespace tribolog::robot {
namespace {

constexpr double angle_slack_rad = 1e-9;  // degrees in a file, turned into radians and back

[[noreturn]] void refuse(const ArmJoint& joint, const std::string& what) {
  throw std::invalid_argument(fmt::format("joint '{}': {}", joint.name, what));
}

void check_shape(const ArmJoint& joint) {
  const LinkShape& shape = joint.shape;
  for (const double size :
       {shape.radius_m, shape.end_radius_m, shape.drum_radius_m, shape.drum_length_m}) {
    if (!(size > 0) || !std::isfinite(size)) {
      refuse(joint, fmt::format("a size of {} m is not allowed; it must be > 0", size));
    }
  }
  if (!(shape.bar_thickness_m >= 0) || !std::isfinite(shape.bar_thickness_m)) {
    refuse(joint, fmt::format("a thickness of {} m is not allowed; it must be >= 0",
                              shape.bar_thickness_m));
  }
}

void check(const ArmJoint& joint) {
  if (joint.name.empty()) throw std::invalid_argument("a joint has no name");
  if (!joint.axis.allFinite() || !(joint.axis.norm() > 0)) {
    refuse(joint, fmt::format("the axis [{}, {}, {}] has no direction", joint.axis.x(),
                              joint.axis.y(), joint.axis.z()));
  }
  if (!joint.offset_m.allFinite()) refuse(joint, "the offset is not finite");
  for (const Eigen::Vector3d& bend : joint.link_bends_m) {
    if (!bend.allFinite()) refuse(joint, "a bend of its link is not finite");
  }
  if (!std::isfinite(joint.lowest_rad) || !std::isfinite(joint.highest_rad) ||
      !(joint.lowest_rad < joint.highest_rad)) {
    refuse(joint, fmt::format("the range of motion from {:.6g}° to {:.6g}° is empty",
                              joint.lowest_rad * joint::degrees_per_rad,
                              joint.highest_rad * joint::degrees_per_rad));
  }
  check_shape(joint);
}

}  // namespace

SerialArm::SerialArm(std::string name, std::vector<ArmJoint> joints, Eigen::Vector3d tool_m)
    : name_(std::move(name)), joints_(std::move(joints)), tool_m_(std::move(tool_m)) {
  if (joints_.empty()) throw std::invalid_argument("the arm has no joint");
  if (!tool_m_.allFinite()) throw std::invalid_argument("the place of the flange is not finite");
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    check(joints_[i]);
    joints_[i].axis.normalize();
    for (std::size_t k = 0; k < i; ++k) {
      if (joints_[k].name == joints_[i].name) refuse(joints_[i], "the name is given twice");
    }
  }
  if (!(length_m() > 0)) {
    throw std::invalid_argument(
        "all joints and the flange lie in one point; the arm needs a length");
  }
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
  throw std::invalid_argument(fmt::format("there is no joint '{}'; the arm has {}", joint, names));
}

ArmPose SerialArm::pose(const std::vector<double>& angles_rad) const {
  if (angles_rad.size() != joints_.size()) {
    throw std::invalid_argument(fmt::format("{} angles for {} joints; it must be one for each",
                                            angles_rad.size(), joints_.size()));
  }
  ArmPose out;
  Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    const ArmJoint& joint = joints_[i];
    const double angle = angles_rad[i];
    if (!(angle >= joint.lowest_rad - angle_slack_rad &&
          angle <= joint.highest_rad + angle_slack_rad)) {
      refuse(joint,
             fmt::format("the angle {:.6g}° lies outside the range of motion, {:.6g}° to "
                         "{:.6g}°",
                         angle * joint::degrees_per_rad, joint.lowest_rad * joint::degrees_per_rad,
                         joint.highest_rad * joint::degrees_per_rad));
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
