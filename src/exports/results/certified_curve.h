#pragma once
// The friction curve of an archived calibration with its uncertainty, for a certificate.

#include <vector>

#include "calibration/read_calibration.h"
#include "exports/results/archived_joint.h"

namespace tribolog::exports::results {

/// Points by growing speed, on one side of the gear.
struct CertifiedCurve {
  std::vector<double> speed_rad_s;  ///< With the sign of the direction, like the friction.
  std::vector<double> friction_Nm;
  std::vector<double> expanded_Nm;  ///< Half widths at 95 %; empty: not known of every point.
  bool from_sweep{};                ///< Parts of a sweep's strokes; else runs at constant speed.
  bool holds_gravity{};  ///< The error of the gravity that was subtracted is in `expanded_Nm`.
  std::vector<calibration::Influence> left_out;  ///< Not stated, and not in `expanded_Nm`.
};

/// What is not in a budget because it is not stated; of a number that was converted by the gear
/// ratio, that too. @param gear_power 0: it was not.
std::vector<calibration::Influence> left_out_of(const calibration::UncertaintyBudget& budget,
                                                int gear_power);

/// What the manifest states of its scale holds for each point as for the Coulomb torque, which is
/// a friction torque too: its share of the point's own torque.
/// @param coulomb what the Coulomb torque rests on. @param gear_power 0: at the motor, 1: at the
/// joint.
CertifiedCurve certified_curve(const ArchivedJoint& joint,
                               const calibration::RecordedEvidence& coulomb, int gear_power);

}  // namespace tribolog::exports::results
