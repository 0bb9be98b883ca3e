#pragma once
// An arm as gravity sees it: joints in a tree, each with the mass of all that it alone carries.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "joint/gravity_load.h"

namespace tribolog::robot {

enum class JointMotion { turning, sliding };

/// A joint that moves as another one does: position = factor times that one's + offset.
struct FollowedJoint {
  std::size_t joint{};
  double factor{1};
  double offset{};  ///< rad or m
};

/// A joint, and what moves with it and with no joint behind it.
struct WeightedJoint {
  std::string name;
  std::optional<std::size_t> parent{};  ///< Joint before it; absent: the base.
  Eigen::Isometry3d at_zero{
      Eigen::Isometry3d::Identity()};  ///< Its frame at position 0, in its parent's frame.
  Eigen::Vector3d axis{0, 0, 1};       ///< Unit vector in its own frame: of positive motion.
  JointMotion motion{JointMotion::turning};
  double mass_kg{};                        ///< >= 0
  Eigen::Vector3d centre_m{0, 0, 0};       ///< Of that mass, in its own frame.
  std::optional<FollowedJoint> follows{};  ///< Absent: it moves by itself.
};

class WeightedArm {
 public:
  /// @param joints each behind its parent.
  /// @throw Refusal naming the joint: a parent or a followed joint that does not stand before it,
  ///        an axis without direction, a number that is not finite, a mass below 0.
  explicit WeightedArm(std::vector<WeightedJoint> joints);

  /// Axes are unit vectors.
  [[nodiscard]] const std::vector<WeightedJoint>& joints() const { return joints_; }
  [[nodiscard]] std::size_t size() const { return joints_.size(); }

  /// What the joint's drive has to give along its axis to hold all that the joint carries against
  /// gravity: -sum over these masses of axis . (lever x m g) [N·m]; of a sliding joint
  /// -sum of axis . m g [N].
  /// @param positions of all joints [rad, m]; of those that follow another one not used.
  /// @param gravity_m_s2 in the base's frame.
  [[nodiscard]] double holding_torque_Nm(std::size_t joint, const std::vector<double>& positions,
                                         const Eigen::Vector3d& gravity_m_s2) const;

  /// Gravity of a turning joint while all others stand: amplitude and angle of the peak of
  /// amplitude cos(q - q_peak), eq. (9).
  [[nodiscard]] joint::StatedGravity gravity_of(std::size_t joint, std::vector<double> positions,
                                                const Eigen::Vector3d& gravity_m_s2) const;

 private:
  std::vector<WeightedJoint> joints_;
};

}  // namespace tribolog::robot
