#pragma once
// The viscous curve of an archived calibration as a table, for simulators that take one.

#include <string>
#include <vector>

#include "exports/results/archived_joint.h"

namespace tribolog::exports::results {

struct FrictionRow {
  double speed_rad_s{};
  double friction_Nm{};
};

/// Motor side. The first row is at rest, speeds grow strictly, torques are > 0.
struct FrictionTable {
  std::vector<FrictionRow> rows;  ///< Empty: there is no curve.
  std::string source;             ///< In words; or why there is no curve.
};

/// The runs at constant speed, half the difference between the directions; of a speed in one
/// direction alone the torque less the offset that the others show. At rest what the slowest one
/// shows. Without such runs the straight line of Coulomb and viscous friction.
FrictionTable friction_table(const ArchivedJoint& joint);

/// At the joint: speeds / n, torques × n.
FrictionTable at_joint(FrictionTable table, double gear_ratio);

}  // namespace tribolog::exports::results
