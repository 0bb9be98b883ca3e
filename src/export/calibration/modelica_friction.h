#pragma once
// The joint's friction curve for Modelica.

#include <string>

#include "export/calibration/archived_joint.h"

namespace tribolog::archive {

/// A model `JointFriction` that extends Modelica.Mechanics.Rotational.Components.BearingFriction
/// with `tau_pos = [w, tau; ...]`, friction [N·m] against speed [rad/s] from 0 on, and `peak`, the
/// break-away torque by the friction at rest, where that is above 1. On the side that the options
/// say: the bearing stands behind the gear (joint) or before it (motor).
/// @throw UsageError: there is no curve, or it is not usable.
std::string modelica_friction(const ArchivedJoint& joint, const SimulatorOptions& options);

}  // namespace tribolog::archive
