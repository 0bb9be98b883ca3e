#pragma once
// A robot arm as a chain of turning joints.
//
// In the zero pose (every angle 0) all frames are parallel to the base's: x forwards, y to the
// left, z upwards. Each joint has its own frame, in which the link that it drives is described.

#include <cstddef>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace tribolog::robot {

/// What a link looks like: round, or a flat bar across its joint's axis. All lengths > 0.
struct LinkShape {
  double radius_m{0.05};      ///< At its own joint.
  double end_radius_m{0.05};  ///< At the next one.
  double bar_thickness_m{};   ///< 0: round.
  double drum_radius_m{0.06};
  double drum_length_m{0.12};
};

struct ArmJoint {
  std::string name;                           ///< As the robot's maker counts: "3".
  Eigen::Vector3d axis{0, 0, 1};              ///< Direction of positive turns.
  Eigen::Vector3d offset_m{0, 0, 0};          ///< From the joint before, in its frame.
  double lowest_rad{};                        ///< Range of motion.
  double highest_rad{};                       ///< > lowest_rad
  std::vector<Eigen::Vector3d> link_bends_m;  ///< Corners of the link, in its own frame.
  LinkShape shape;
};

/// Where everything is in one pose.
struct ArmPose {
  std::vector<Eigen::Isometry3d> frames;  ///< Of each joint, in the base's frame.
  Eigen::Vector3d tool_m;                 ///< Of the flange.
  Eigen::Isometry3d tool_frame;
};

class SerialArm {
 public:
  /// @param tool_m flange, in the frame of the last joint
  /// @throw Refusal stating the joint, the value and the rule: no joint, an axis
  /// without direction, numbers that are not finite, an empty range of motion, a size that is not
  /// positive, a name given twice, all joints and the flange in one point.
  SerialArm(std::string name, std::vector<ArmJoint> joints, Eigen::Vector3d tool_m);

  [[nodiscard]] const std::string& name() const { return name_; }
  /// Axes are unit vectors.
  [[nodiscard]] const std::vector<ArmJoint>& joints() const { return joints_; }
  [[nodiscard]] const Eigen::Vector3d& tool_m() const { return tool_m_; }
  [[nodiscard]] std::size_t size() const { return joints_.size(); }
  /// All lengths of the chain laid end to end, > 0: a scale for what stands around the arm.
  [[nodiscard]] double length_m() const;
  /// @throw Refusal naming the joints that there are.
  [[nodiscard]] std::size_t index_of(const std::string& joint) const;

  /// @throw Refusal if there are not as many angles as joints, or one lies outside
  /// its range of motion.
  [[nodiscard]] ArmPose pose(const std::vector<double>& angles_rad) const;
  /// Axis of a joint in the base's frame.
  [[nodiscard]] Eigen::Vector3d axis(const ArmPose& pose, std::size_t joint) const;

 private:
  std::string name_;
  std::vector<ArmJoint> joints_;
  Eigen::Vector3d tool_m_;
};

}  // namespace tribolog::robot
