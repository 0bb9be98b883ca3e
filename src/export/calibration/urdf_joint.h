#pragma once
// The joint's friction as URDF.

#include <string>

#include "export/calibration/archived_joint.h"

namespace tribolog::archive {

/// A robot of two links with the joint between them, which a parser of URDF loads; its `<dynamics>`
/// is to be copied. Joint side: `damping` is the viscous coefficient [N·m·s/rad], `friction` the
/// Coulomb torque [N·m].
/// @throw UsageError: one of the two is missing, or not usable.
std::string urdf_joint(const ArchivedJoint& joint, const SimulatorOptions& options);

}  // namespace tribolog::archive
