#pragma once
// The curves that a calibration file holds, for drawing two of them over each other.

#include <string>
#include <vector>

namespace tribolog::history {

/// Friction over speed, a point for each constant-speed run. SI, motor side.
struct RecordedFriction {
  std::string estimator;  ///< By whose gravity the friction is what is left.
  std::vector<double> speed_rad_s;
  std::vector<double> friction_Nm;
  std::vector<double> half_width_Nm;  ///< Of the torque.
};

/// One oscillation's steady loop.
struct RecordedLoop {
  double centre_rad{};                  ///< Joint.
  std::vector<double> from_centre_rad;  ///< Joint angle less the centre.
  std::vector<double> torque_Nm;        ///< Motor side.
};

struct RecordedCurves {
  RecordedFriction friction;        ///< Empty where there are no runs.
  std::vector<RecordedLoop> loops;  ///< Empty where none was recorded, or by an older program.
};

/// @param json of `tribolog identify`; members that are missing or of another type are taken for
///        not recorded: the numbers are compared all the same.
RecordedCurves recorded_curves(const std::string& json);

}  // namespace tribolog::history
