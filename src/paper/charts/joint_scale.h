#pragma once
// Parameters for the paper's static laws, of which it prints none.
//
// Sizes are those of the paper's joint at the motor: the break-away torque that its hysteresis
// loop has (0.884 N·m), and Coulomb torque, Stribeck velocity and viscous slope with which eq. (1)
// follows the reconstructed curve of eq. (6) in the large: 0.45 N·m at its dip and about 1.17 N·m
// at 300 rad/s.

#include "friction/static_laws.h"

namespace tribolog::paper::charts {

/// Eq. (1).
friction::StribeckFriction stribeck_at_joint_scale();

/// Eq. (2) with the same torques and slope; its Stribeck effect decays over the Stribeck velocity
/// of the former, and its threshold is the largest that the paper names.
friction::ThresholdSpeedFriction linear_zone_at_joint_scale();

}  // namespace tribolog::paper::charts
