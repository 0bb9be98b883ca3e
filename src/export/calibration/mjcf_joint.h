#pragma once
// The joint's friction as MJCF, MuJoCo's format.

#include <string>

#include "export/calibration/archived_joint.h"

namespace tribolog::archive {

/// A model of one body on one hinge, which MuJoCo loads; its `<joint>` is to be copied. Joint side:
/// `damping` is the viscous coefficient [N·m·s/rad], `frictionloss` the Coulomb torque [N·m].
///
/// `armature` is the rotor's inertia [kg·m²] as the joint feels it. The loop and the sweep show the
/// inertia of rotor, gear and arm together, and a model has the arm's in its bodies: it is the
/// identified one less `arm_inertia_kgm2`, and left out, with a comment, where that is not known or
/// the difference is not above zero.
/// @throw UsageError: viscous coefficient or Coulomb torque is missing, or not usable.
std::string mjcf_joint(const ArchivedJoint& joint, const SimulatorOptions& options);

}  // namespace tribolog::archive
