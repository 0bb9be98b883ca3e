#pragma once
// The robot's other joints while one is recorded: how far they moved, and what an arm's masses say
// about their effect on its gravity.

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "joint/gravity_load.h"

namespace tribolog::joint {

/// Another joint, whose angle may stand in the logs of this one.
struct OtherJoint {
  std::string name;
  std::string angle;            ///< Column of the log.
  double radian_per_unit{1.0};  ///< To the angle at the joint: unit, sign and gear.
  std::string stated_at;        ///< "robot.toml:14", for messages.

  std::size_t samples{};  ///< In which the angle was logged; counted when reading.
  double lowest_rad{};    ///< Over all recordings of the tested joint; 0 without samples.
  double highest_rad{};

  [[nodiscard]] double travel_rad() const { return highest_rad - lowest_rad; }
};

/// Where a joint of the description stands for comparison.
struct HeldJoint {
  std::string name;       ///< In the description.
  double position_rad{};  ///< Of a sliding one [m].
  bool is_logged{};       ///< false: no column holds it, and 0 is assumed.
};

/// Gravity by the masses of a description (URDF): what the others' motion changes of it, against a
/// posture in which they stand, was subtracted from the torque when reading. Torques at the joint.
struct ArmGravity {
  std::string description;                             ///< File, relative to the manifest.
  std::array<double, 3> gravity_m_s2{0, 0, -9.80665};  ///< In the base's frame.
  double description_percent{10};    ///< Half width at 95 % of the masses and their centres.
  std::string tested;                ///< The tested joint's name in the description.
  bool is_by_order{};                ///< Joints were matched by their order, for want of names.
  std::vector<HeldJoint> held;       ///< The posture: the means over the first sweep.
  std::optional<StatedGravity> own;  ///< Of the tested joint in that posture.
  std::size_t samples{};             ///< From which it was subtracted.
  double largest_Nm{};               ///< Largest size subtracted.
};

}  // namespace tribolog::joint
